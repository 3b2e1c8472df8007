"""Required `find_package()` calls for packages that package.xml does not declare (DEP104)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fnmatch import fnmatchcase
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.aliases import NOTHING_NEEDED, keys_for_cmake
from ...ros.distros import Targets
from ...ros.implied_dependencies import IN_CMAKE, implied_by
from ...ros.names import NameKind
from ...ros.rosdep import NOT_THERE
from ...suggest import near_names
from .brought_dependencies import Bringer
from .declared_dependencies import DeclaredDependencies
from .own_places import looks_elsewhere

REPORTED_ELSEWHERE = frozenset({"ament_cmake"})
"""Packages whose absence from package.xml other rules report."""

BARE = frozenset({"protobuf"})
"""Keys of libraries without headers that are not called `lib…`."""

OF_COMMANDS = {
    "ament_add_gtest": "ament_cmake_gtest",
    "ament_add_gtest_executable": "ament_cmake_gtest",
    "ament_add_gmock": "ament_cmake_gmock",
    "ament_add_gmock_executable": "ament_cmake_gmock",
    "ament_add_pytest_test": "ament_cmake_pytest",
    "ament_add_google_benchmark": "ament_cmake_google_benchmark",
    "add_launch_test": "launch_testing_ament_cmake",
    "add_ros_test": "ros_testing",
    "ament_lint_auto_find_test_dependencies": "ament_lint_auto",
}
"""The one package without which each command for tests stops CMake."""


@dataclass(frozen=True, slots=True)
class UndeclaredFindPackage:
    """A package that CMake finds, and the names that provide it; the first is the one to recommend."""

    found: FoundPackage
    names: tuple[str, ...]
    bringer: Bringer | None
    """The declared dependency that it comes with, or may come with; None where none brings it."""
    is_installable: bool
    """Whether rosdep installs something for it on a supported distribution."""


@dataclass(frozen=True)
class FindPackageDependencies:
    """The packages that CMake looks for, and what package.xml declares."""

    declared: DeclaredDependencies
    cmake: CMake
    interfaces: tuple[InterfaceFile, ...] = ()

    def missing(self) -> tuple[UndeclaredFindPackage, ...]:
        """Return what CMake can't do without and package.xml does not declare, each once; tests come last."""
        return self._missing

    @cached_property
    def _missing(self) -> tuple[UndeclaredFindPackage, ...]:
        return tuple(self.undeclared())

    def undeclared(self) -> Iterator[UndeclaredFindPackage]:
        """Yield what `missing` returns, found out anew."""
        if not self.declared.is_checked:
            return
        there = implied_by(self.declared.names, IN_CMAKE)
        seen: set[str] = set()
        for found in sorted(self.cmake.packages, key=lambda each: each.call.testing):
            if found.name in seen or not self.is_needed(found):
                continue
            seen.add(found.name)
            names = (*self.of_components(found), *self.providers(found.name))
            if names and not self.declared.has(names) and not there.intersection(names):
                yield UndeclaredFindPackage(
                    found, names, self.bringer(found.name, names), self.is_installable(names[0])
                )

    def of_components(self, found: FoundPackage) -> tuple[str, ...]:
        """Return the key of rosdep for the one component of Boost that is asked for, or that of all; headers alone
        need none."""
        keys = [f"libboost-{each.text.replace('_', '-')}-dev" for each in found.components if found.name == "Boost"]
        known = [key for key in dict.fromkeys(keys) if self.declared.workspace.index.is_key(key)]
        return tuple(known) if len(known) < 2 else ("boost",)

    def is_declared_alike(self, name: str) -> bool:
        """Return whether package.xml declares a name, or one that serves it or that it is a slip of."""
        declared = self.declared.names
        return self.declared.has([name]) or bool(near_names(name, declared) or self.matching_names(name, declared))

    @cached_property
    def handed_to_ament(self) -> frozenset[str]:
        """What commands of ament are given, which take packages that ament makes."""
        calls = self.cmake.named("ament_target_dependencies", "ament_export_dependencies")
        return frozenset(word.text for call in calls for word in call.words if not word.maybe and not call.maybe)

    def needed_providers(self, found: FoundPackage) -> tuple[str, ...]:
        """Return the names that provide a package without which the configuration certainly fails; else nothing."""
        return self.providers(found.name) if self.is_needed(found) else ()

    def bringer(self, name: str, names: tuple[str, ...]) -> Bringer | None:
        """Return the declared dependency that brings a package of CMake, or may do so, by any of its names."""
        there = self.declared.brings.brought_to_build
        brought = (*there.certain, *there.perhaps)
        alike = (*self.matching_names(name, brought), *self.matching_names(name, brought, of_run_time=True))
        return self.declared.bringer((*names, *alike), runs=False)

    def is_installable(self, name: str) -> bool:
        """Return whether a name is a package, or a key with a rule for a distribution that is supported."""
        workspace = self.declared.workspace
        if workspace.is_available(name) or workspace.index.is_package(name):
            return True
        return any(workspace.index.installer(name, each) != NOT_THERE for each in Targets())

    def is_needed(self, found: FoundPackage) -> bool:
        """Return whether the configuration certainly fails without it."""
        certain = found.word.is_known and not found.word.maybe and not found.call.maybe
        needed = found.is_required or (found.name in self.needed_names and not found.is_quiet)
        return certain and needed and not self.is_reported_elsewhere(found.name)

    @cached_property
    def needed_names(self) -> frozenset[str]:
        """What a target, an export or a command requires, with or without REQUIRED in find_package."""
        calls = (call for call in self.cmake.calls if not call.maybe and call.name not in self.cmake.functions)
        found = {*self.handed_to_ament, *(OF_COMMANDS[call.name] for call in calls if call.name in OF_COMMANDS)}
        for call in self.cmake.named("target_link_libraries"):
            linked = (word.text.partition("::") for word in call.words[1:] if not word.maybe and not call.maybe)
            found |= {package for package, colons, _ in linked if colons}
        return frozenset(found)

    def is_reported_elsewhere(self, name: str) -> bool:
        """Return whether another rule reports it: that for build tools, or those for interfaces."""
        generates = name == "rosidl_default_generators" and bool(self.cmake.interface_targets)
        typed = any(each.package == name for interface in self.interfaces for each in interface.types)
        return name in REPORTED_ELSEWHERE or generates or typed

    def providers(self, name: str) -> tuple[str, ...]:
        """Return the names that provide find_package(name); nothing where they are unknown or need no declaration."""
        listed = keys_for_cmake(name)
        if NOTHING_NEEDED in listed:
            return ()
        is_known = name not in listed and self.declared.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        own = (name,) if is_known else ()
        itself = self.declared.facts.name
        known = tuple(each for each in (*own, *listed) if "*" not in each and each != itself)
        return (*known, *self.matching_names(name, self.declared.names)) if known else ()

    def matching_names(self, name: str, names: Iterable[str], *, of_run_time: bool = False) -> tuple[str, ...]:
        """Return the names that fit a pattern of the table, or are called like a package of a vendor or Debian.

        A library may be a ROS package and a rosdep key as well: `octomap` and `liboctomap-dev`. With `of_run_time`, the
        keys of libraries without headers are returned, which serve no build.
        """
        patterns = [each for each in keys_for_cmake(name) if "*" in each]
        lower = name.lower()
        debian, own = lower.replace("_", "-"), lower.replace("-", "_")
        alike = {f"{own}_vendor", f"lib{debian}-dev", f"{debian}-dev", f"lib{debian}", *BARE.intersection((lower,))}
        is_alike = [n for n in names if n.lower() in alike or any(fnmatchcase(n, p) for p in patterns)]
        return tuple(n for n in is_alike if self.is_for_run_time(n) is of_run_time)

    def is_for_run_time(self, key: str) -> bool:
        """Return whether a key is that of a library without its headers, which another one has: `libboost-thread`."""
        index = self.declared.workspace.index
        is_bare = key in BARE or key.startswith("lib")
        return is_bare and index.is_key(f"{key}-dev") and not index.is_package(key)

    def is_elsewhere(self, found: FoundPackage, names: Iterable[str]) -> bool:
        """Return whether it is a library of the system that CMake looks for in a folder of its own."""
        index = self.declared.workspace.index
        is_library = any(index.is_key(each) and not index.is_package(each) for each in names)
        return is_library and looks_elsewhere(found, self.cmake)

    def for_run_time(self, found: FoundPackage) -> str:
        """Return what package.xml declares of a library without its headers; "" for nothing."""
        return next(iter(self.matching_names(found.name, sorted(self.declared.names), of_run_time=True)), "")
