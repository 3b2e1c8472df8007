"""The other packages and libraries whose headers the compiled C++ files of a package include."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cpp.common_includes import common_includes
from ...languages.cpp.defined_conditions import is_under_defined
from ...languages.cpp.file import CppFile, IncludeDirective
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role
from ...ros.libraries import keys_of_header
from ...source import Span
from .compiled_sources import compiled_sources, own_compiled
from .conditional_includes import only_under_conditions
from .header_providers import HeaderProviders
from .ros1_headers import Ros1Headers
from .unnamed_sources import UnnamedSources


@dataclass(frozen=True, slots=True)
class IncludeUse:
    """A header of another package, and the file that includes it."""

    path: str
    span: Span
    header: str
    is_type: bool = False
    """Whether it is a generated type, `nav_msgs::msg::Odometry`, whose header another header includes."""


@dataclass(frozen=True, slots=True)
class IncludedPackage:
    """The provider of some includes: any of the names will do, the first is the one to recommend."""

    names: tuple[str, ...]
    cmake: str
    """The name for find_package."""
    role: Role
    uses: tuple[IncludeUse, ...]


@dataclass(frozen=True)
class IncludedPackages:
    providers: HeaderProviders
    ros1: Ros1Headers
    cmake: CMake
    sources: tuple[CppFile, ...]

    def all(self) -> Iterator[IncludedPackage]:
        """Yield each package or library whose headers are included, those of tests after those of what is built."""
        found: dict[tuple[Role, tuple[str, ...], str], list[IncludeUse]] = {}
        unnamed = UnnamedSources(self.providers.files)
        is_known = own_compiled(self.cmake, self.sources) is not None
        for source, role in compiled_sources(self.cmake, self.sources):
            is_left = role == "aside" or (not is_known and unnamed.has(source.path))
            for names, cmake, use in self.included_by(source) if not is_left else ():
                found.setdefault((role, names, cmake), []).append(use)
        for (role, names, cmake), uses in sorted(found.items(), key=lambda item: item[0][0] == "test"):
            if role != "test" or ("run", names, cmake) not in found:
                yield IncludedPackage(names, cmake, role, tuple(uses))

    def included_by(self, source: CppFile) -> Iterator[tuple[tuple[str, ...], str, IncludeUse]]:
        """Yield what a file certainly includes of others: the providers, the name for find_package, and the place."""
        always = always_included(source)
        for each in source.includes:
            folder, slash, _ = each.path.partition("/")
            is_certain = not each.is_conditional or folder in always or self.is_switched_on(source, each)
            if (slash or keys_of_header(each.path)) and is_certain and not self.providers.is_own(each.path):
                names, cmake = self.providers.of(each.path)
                is_open = source.path in self.guarded or not self.ros1.may_be_in_ros2(each.path)
                if names and not is_open and self.outside.isdisjoint((folder, *names)):
                    yield names, cmake, IncludeUse(source.path, each.span, each.path)

    def is_switched_on(self, source: CppFile, include: IncludeDirective) -> bool:
        """Return whether the conditions around an include ask for macros that CMake defines for all targets."""
        macros = self.macros
        return bool(macros) and is_under_defined(source.source.text, include.span.start, macros)

    @cached_property
    def macros(self) -> frozenset[str]:
        """The macros that CMake defines for all targets in any case."""
        calls = self.cmake.named("add_definitions", "add_compile_definitions")
        words = (word for call in calls if not (call.maybe or call.folder or call.testing) for word in call.words)
        texts = (word.text for word in words if word.is_known and not word.maybe)
        return frozenset(text.removeprefix("-D").partition("=")[0] for text in texts if not text.endswith("=0"))

    @cached_property
    def outside(self) -> frozenset[str]:
        """The parts of include directories outside of the package: their headers are found without a declaration."""
        calls = self.cmake.named("include_directories", "target_include_directories")
        words = ((word.text, path_in_package(word.text, call.folder)) for call in calls for word in call.words)
        return frozenset(part for text, path in words if path is None and "../" in text for part in text.split("/"))

    @cached_property
    def guarded(self) -> frozenset[str]:
        """The headers that the files of the package include inside of `#if` alone."""
        return only_under_conditions(self.cmake, self.sources)


def always_included(source: CppFile) -> frozenset[str]:
    """Return the folders of which each branch of an `#if … #else` includes a header."""
    if not any(each.is_conditional for each in source.includes):
        return frozenset()
    return common_includes(source.source.text, {each.span.start for each in source.includes})
