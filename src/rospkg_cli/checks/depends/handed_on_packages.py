"""Packages that CMake files require which every package that uses this one runs (DEP111)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.file import read_file
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.macro_installs import handed_on
from ...ros.manifest import EXPORTED, RUNS, is_buildtool
from ...source import Span
from ...unreadable import UnreadableError
from ..cmake.consumers import Consumers
from .declared_dependencies import DeclaredDependencies
from .find_package_providers import FindPackageProviders
from .name_source import is_installable
from .repository_dependencies import NO_INSTALL
from .transitive_dependencies import exported_by, with_members

RUNTIME = "rosidl_default_runtime"
"""What every package of interfaces exports, and each machine of ROS has."""


@dataclass(frozen=True, slots=True)
class HandedOnPackage:
    """A package that a file requires in the CMake of other packages, and that package.xml does not export."""

    names: tuple[str, ...]
    """Its providers, the one to recommend first."""
    cmake: str
    """What `find_package()` calls it."""
    path: str
    span: Span
    is_certain: bool
    """Whether all exports are known entirely, and a package that uses an export is known."""
    is_installed: bool
    """Whether rosdep installs it wherever the repository is built: it is missing only from a release."""


@dataclass(frozen=True)
class HandedOnPackages:
    declared: DeclaredDependencies
    files: PackageFiles
    cmake: CMake
    consumers: Consumers

    def stops(self, names: Collection[str]) -> bool:
        """Return whether a package is built against this one, and nothing that it declares brings the missing one."""
        return any(self.consumers.lacks(each, names) for each in self.consumers.builders)

    def is_installed(self, names: Collection[str]) -> bool:
        """Return whether this package declares what is missing for itself, or another of the repository does.

        What lies in the workspace is another matter: colcon shows a package only what is handed on to it.
        """
        declared = self.declared
        if any(map(declared.workspace.named, names)):
            return False
        own = {need.name for need in declared.facts.dependencies if need.certain and need.tag != NO_INSTALL}
        is_declared = not own.isdisjoint(names) or declared.otherwise.is_declared_by_others(names)
        return is_declared and is_installable(declared, names)

    def is_met(self, names: Collection[str]) -> bool:
        """Return whether a missing export may do harm: there is a release, or nothing here installs the package."""
        return self.declared.release.is_made or not self.is_installed(names)

    def missing(self) -> Iterator[HandedOnPackage]:
        """Yield each package once, at the first call that requires it outside of blocks."""
        there, known = self.handed_on
        providers = FindPackageProviders(self.declared)
        seen: set[str] = set()
        for path in self.paths if self.declared.is_checked else ():
            for name, span in self.required(path):
                names = providers.of(name)
                if names and name not in seen and self.declared.facts.name != name and not there.intersection(names):
                    seen.add(name)
                    is_met = (self.consumers.are_elsewhere or self.stops(names)) and self.is_met(names)
                    yield HandedOnPackage(names, name, path, span, known and is_met, self.is_installed(names))
        yield from self.exported(seen, providers)

    def exported(self, seen: set[str], providers: FindPackageProviders) -> Iterator[HandedOnPackage]:
        """Yield what `ament_export_dependencies()` names and package.xml has for its own build alone, or not at all.

        What comes with something that users get is there.
        """
        tags, declared = RUNS | EXPORTED, self.declared.manifest.dependencies
        known = {each.name for each in self.cmake.packages} | {RUNTIME}
        there = self.declared.brings.brought_with(tags)
        got = {need.name for need in declared if need.tag in tags}
        for call in self.cmake.named("ament_export_dependencies") if self.declared.is_checked else ():
            for word in call.words if not (call.maybe or call.folder) else ():
                names = providers.of(word.text) if word.is_known and not word.maybe else ()
                own = tuple(dict.fromkeys(need.name for need in declared if need.name in names))
                is_absent = not own and word.text not in known and not self.declared.has(names)
                own = names if is_absent else own
                if not own or word.text in seen or not got.isdisjoint(names) or any(map(is_buildtool, own)):
                    continue
                seen.add(word.text)
                bringer = self.declared.brings.bringer_among(names, there)
                if bringer is None or not bringer.is_certain:
                    is_met = bringer is None and self.stops({*own, *names}) and self.is_met(own)
                    place, there_too = (word.path, word.span), self.is_installed(own)
                    yield HandedOnPackage(own, word.text, *place, is_met, there_too)

    @cached_property
    def handed_on(self) -> tuple[frozenset[str], bool]:
        """What this package exports, directly or through others, and whether all of it is known."""
        first = [need.name for need in self.declared.facts.dependencies if need.tag in EXPORTED]
        brought, known = exported_by(first, self.declared.workspace)
        return frozenset(with_members(first, self.declared.workspace)) | brought, known

    @property
    def paths(self) -> list[str]:
        """The files that `ament_package(CONFIG_EXTRAS …)` names, as they lie in the package; templates too."""
        words = [(word, call) for call in self.cmake.calls for word in handed_on(call, self.cmake)]
        found = (path_in_package(word.text, call.folder) for word, call in words if word.is_known and not call.maybe)
        return [path for path in dict.fromkeys(found) if path is not None and self.files.exists(path)]

    def required(self, path: str) -> Iterator[tuple[str, Span]]:
        """Yield what a file requires in any case, and where each name stands."""
        try:
            file = read_file(self.files, path)
        except UnreadableError:
            return
        for command in file.top:
            words = [argument.text for argument in command.arguments]
            if command.name == "find_package" and "REQUIRED" in words[1:]:
                yield words[0], command.arguments[0].span
