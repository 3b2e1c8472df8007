"""The packages whose headers a CMake target opens in any case, also by way of the package's own headers."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...source import Span
from .header_inclusions import Inclusions
from .sources_by_use import sources_by_use
from .undeclared_includes import IncludeDependencies

OF_TESTS = frozenset(f"ament_add_{kind}{end}" for kind in ("gtest", "gmock") for end in ("", "_executable"))
"""Commands that make targets of tests: the first argument is the target, the others are sources or options."""


@dataclass(frozen=True)
class TargetIncludes:
    includes: IncludeDependencies

    def of(self, target: Target) -> Iterator[tuple[str, tuple[str, str, Span]]]:
        """Yield the packages whose headers the sources of a target include in any case, with path, header and place."""
        sources = target.call.words[1:] if target.call.name in OF_TESTS else target.sources
        words = (word for word in sources if word.is_known and not word.maybe)
        paths = {path_in_package(word.text, target.call.folder) for word in words}
        known, _ = sources_by_use(self.includes.cmake, self.includes.sources)
        opened = paths & (known.own | known.tests)
        for path in sorted(self.inclusions.reached(path for path in opened if path in self.files)):
            for each in self.files[path].includes:
                slash = "/" in each.path
                is_certain = not each.is_conditional and not self.includes.providers.is_own(each.path)
                if slash and is_certain and self.includes.ros1.headers.may_be_in_ros2(each.path):
                    names, cmake = self.includes.providers.of(each.path)
                    if names[:1] == (cmake,) and path not in self.includes.included.guarded:
                        yield cmake, (path, each.path, each.span)

    @cached_property
    def files(self) -> dict[str, CppFile]:
        """The C++ files of the package, by path."""
        return {source.path: source for source in self.includes.sources}

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions(self.files, only_certain=True, unconditional=True)
