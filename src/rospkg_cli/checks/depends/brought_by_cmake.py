"""What the build has because CMake requires it, declared or not, and what comes with that."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...ros.libraries import is_named_among, keys_of_module
from .brought_dependencies import Bringer, brought_by
from .included_packages import IncludedPackage
from .required_by_cmake import required_modules, required_packages
from .undeclared_find_package import FindPackageDependencies


@dataclass(frozen=True)
class BroughtByCMake:
    cmake: CMake
    find_packages: FindPackageDependencies
    workspace: Workspace

    def requires(self, each: IncludedPackage) -> bool:
        """Return whether CMake itself requires an included package, and so stops before the compiler does."""
        if not {each.cmake, *each.names}.isdisjoint(required_packages(self.cmake)):
            return True
        modules = tuple(required_modules(self.cmake))
        return any(is_named_among(name, modules) for name in each.names)

    def bringer(self, names: tuple[str, ...], *, in_tests: bool) -> Bringer | None:
        """Return the package or library that CMake stops without and that brings one of some names; None for none."""
        found = [one for one in self.cmake.packages if one.is_required and not one.call.maybe]
        named = {one.name for one in found if in_tests or not one.call.testing}
        wanted = {key for name in named for key in (name, *self.find_packages.provided.of(name)[:1])}
        there = brought_by(sorted(wanted), self.workspace)
        by_package = next((Bringer(there[name]) for name in names if name in there), None)
        return by_package or self.module_bringer(names, in_tests)

    def module_bringer(self, names: tuple[str, ...], in_tests: bool) -> Bringer | None:
        """Return the library of a required module of pkg-config that brings one of some names.

        A library that is one of the names itself, or that comes with one of them, is none.
        """
        modules = required_modules(self.cmake, with_tests=in_tests)
        wanted = dict.fromkeys(key for each in modules for key in keys_of_module(each)[:1] if key not in names)
        there = brought_by(wanted, self.workspace)
        found = [(name, there[name]) for name in names if name in there]
        return next((Bringer(by) for name, by in found if by not in brought_by([name], self.workspace)), None)
