"""Rule input: the calls of rosidl_generate_interfaces of a package, and the interface files that they list."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.made_paths import MadePaths
from ...package.interfaces.interface_file import InterfaceFile
from ...package.interfaces.listed_interfaces import ListedInterface
from ...suggest import nearest

OTHER_VARIABLE = regex(r"\$\{(?!PROJECT_NAME\}|CMAKE_PROJECT_NAME\})")


@dataclass(frozen=True)
class RosidlTargets:
    cmake: CMake
    interfaces: tuple[InterfaceFile, ...]
    """All interface files of the package, listed or not."""

    @cached_property
    def listed(self) -> tuple[ListedInterface, ...]:
        return tuple(
            ListedInterface(word, target, target.path_of(word))
            for target in self.cmake.interface_targets
            for word in target.files
        )

    @property
    def is_complete(self) -> bool:
        """Whether all files that code is generated from are known."""
        return self.cmake.knows_interfaces and bool(self.listed or self.empty)

    @property
    def empty(self) -> EvaluatedCommand | None:
        """The only call of the package, if it names no file, neither literally nor by a variable."""
        calls = [each.call for each in self.cmake.interface_targets]
        if self.listed or len(calls) != 1 or calls[0].maybe:
            return None
        text = self.cmake.file(calls[0].path).source.slice(calls[0].command.span)
        return calls[0] if not OTHER_VARIABLE.search(text) else None

    def missing(self) -> Iterator[ListedInterface]:
        """Yield each listed file that neither exists nor is written by a command."""
        made, files = MadePaths(self.cmake), self.cmake.package_files
        for each in self.listed:
            path = each.path if each.word.is_known and not each.word.maybe and not each.target.call.maybe else ""
            if path and not (files.has_file(path) or files.absent.is_expected(path) or made.is_made(path)):
                yield each

    @cached_property
    def renamed(self) -> dict[str, str]:
        """The file that is there under a similar name, for each missing file that has one."""
        known = [each.path for each in self.interfaces]
        lower = {path.lower(): path for path in known}
        paths = (path for each in self.missing() if (path := each.path))
        near = ((path, lower.get(path.lower()) or nearest(path, known)) for path in paths)
        return {path: name for path, name in near if name is not None}

    def repeated(self) -> Iterator[tuple[ListedInterface, ListedInterface]]:
        """Yield each file that one call lists again, with the first place that lists it."""
        for target in self.cmake.interface_targets:
            seen: dict[str, ListedInterface] = {}
            for each in self.listed:
                if each.target is target and each.path and not each.word.maybe:
                    first = seen.setdefault(each.path, each)
                    if first is not each:
                        yield each, first
