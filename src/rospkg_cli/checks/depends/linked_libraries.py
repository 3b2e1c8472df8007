"""Libraries of the system that CMake links or looks for, and that package.xml does not declare (DEP115)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.target_links import TargetLinks
from ...ros.libraries import keys_of_linked, keys_of_module
from ...source import Span
from .brought_dependencies import Bringer
from .own_places import has_linker_folders, searched_places
from .required_by_cmake import ASKS, without_version
from .undeclared_includes import IncludeDependencies

FINDS = ("find_library",)
ELSEWHERE = ("HINTS", "PATHS", "NO_DEFAULT_PATH")
"""With one of these keywords of `find_library()` a library may lie in a folder of its own."""
Keys = Callable[[str], tuple[str, ...]]
"""From the name of a library to the rosdep keys that serve it."""


@dataclass(frozen=True, slots=True)
class LinkedLibrary:
    name: str
    keys: tuple[str, ...]
    """The rosdep keys that serve it, the one to recommend first."""
    testing: bool
    path: str
    span: Span


@dataclass(frozen=True)
class LinkedLibraries:
    includes: IncludeDependencies

    def undeclared(self) -> Iterator[LinkedLibrary]:
        """Yield each library once that the build certainly needs and that neither DEP104 nor DEP105 reports."""
        declared, providers = self.includes.declared, self.includes.providers
        found = sorted(self.used(), key=lambda each: each.testing) if declared.is_checked else []
        seen = self.reported if found else set[str]()
        for each in found:
            if seen.isdisjoint(each.keys) and not declared.has(each.keys) and not providers.is_at_hand(each.name):
                yield each
            seen.update(each.keys)

    def bringer(self, each: LinkedLibrary) -> Bringer | None:
        """Return what brings a library, or may: a declared dependency, or another that CMake stops without."""
        declared = self.includes.declared.bringer(each.keys, runs=False)
        certain = declared is not None and declared.is_certain
        return declared if certain else self.includes.required.bringer(each.keys, in_tests=each.testing) or declared

    @cached_property
    def reported(self) -> set[str]:
        """What DEP104 reports of find_package(), and DEP105 of headers."""
        found = {name for each in self.includes.find_packages.missing() for name in each.names}
        return found | {name for each in self.includes.undeclared() for name in each.names}

    def used(self) -> Iterator[LinkedLibrary]:
        yield from self.linked() if not has_linker_folders(self.cmake) else ()
        for call in self.cmake.calls if not searched_places(self.cmake) else ():
            if call.name in FINDS and not call.maybe and not any(word in call.texts for word in ELSEWHERE):
                yield from self.asked_for(call, keys_of_linked)
            elif call.name in ASKS and not call.maybe:
                yield from self.asked_for(call, keys_of_module)

    def linked(self) -> Iterator[LinkedLibrary]:
        """Yield the plain names that targets are linked with, but for targets and files of the package."""
        for link in TargetLinks(self.cmake).all:
            name = link.word.text.removeprefix("-l")
            is_certain = link.word.is_known and not (link.package or link.word.maybe or link.call.maybe)
            is_certain = is_certain and not self.is_on_demand(link.target)
            if is_certain and (keys := keys_of_linked(name)) and not self.is_own(name):
                yield LinkedLibrary(name, keys, link.call.testing, link.word.path, link.word.span)

    def asked_for(self, call: EvaluatedCommand, keys_of: Keys) -> Iterator[LinkedLibrary]:
        """Yield the libraries that a command finds, if it requires them, or a target is certainly linked with them."""
        result, words = call.texts[:1], call.words[1:]
        if "REQUIRED" not in call.texts and not (result and self.is_linked(result[0])):
            return
        sure = [(word, without_version(word.text)) for word in words if word.is_known and not word.maybe]
        found = [
            LinkedLibrary(name, keys, call.testing, word.path, word.span)
            for word, name in sure
            if (keys := keys_of(name))
        ]
        yield from found if call.name == "pkg_check_modules" else found[:1]

    def is_linked(self, variable: str) -> bool:
        """Return whether a target is certainly linked with what a command found."""
        ways = (f"${{{variable}", f"PkgConfig::{variable}")
        return any(
            argument.text.startswith(ways)
            for call in self.cmake.named("target_link_libraries")
            for argument in (() if call.maybe else call.command.arguments)
        )

    def is_on_demand(self, name: str) -> bool:
        """Return whether `colcon build` passes over a target."""
        target = self.cmake.target(name)
        return target is not None and "EXCLUDE_FROM_ALL" in target.options

    def is_own(self, name: str) -> bool:
        """Return whether a library is a target of the package, or one of its files."""
        files = self.cmake.package_files.paths
        return self.cmake.target(name) is not None or any(f"lib{name}." in path for path in files)

    @property
    def cmake(self) -> CMake:
        return self.includes.cmake
