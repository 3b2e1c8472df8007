"""The names of packages that CMake finds and package.xml declares, and whether another name can be one of them."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.config_files import in_other_case
from ...ros.link_targets import ROS_NAME
from ...ros.names import NameKind

AMENT = "ament_"


@dataclass(frozen=True)
class PackageNames:
    package: CMakePackage
    workspace: Workspace

    @property
    def cmake(self) -> CMake:
        return self.package.cmake

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake finds."""
        return frozenset(each.name for each in self.cmake.packages)

    @property
    def found_in_capitals(self) -> frozenset[str]:
        """The names in capitals of libraries that CMake finds: Eigen3Config.cmake sets EIGEN3_FOUND too.

        `find_package_handle_standard_args(ompl)` sets OMPL_FOUND; what ament writes for a package sets no other.
        """
        found = (name for name in self.found if name != name.lower() or not self.workspace.is_cased(name))
        return frozenset(map(str.upper, found))

    @cached_property
    def declared(self) -> frozenset[str]:
        """The packages that the manifest names, which `ament_auto_…` finds."""
        return frozenset(each.name for each in self.package.manifest.dependencies)

    @cached_property
    def unfound(self) -> frozenset[str]:
        """The declared packages that CMake does not look for under their right names, and all packages of ament."""
        packages = [name for name in self.declared if self.workspace.kind_of(name) is NameKind.PACKAGE]
        tools = [name for name in self.workspace.index.packages if name.startswith(AMENT)]
        return frozenset(packages) - self.found | frozenset(tools)

    def is_known(self, name: str) -> bool:
        """Return whether a name is that of a package or of a rosdep key, or is declared, which DEP001 judges."""
        known = self.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        return known or name in self.declared or self.workspace.is_available(name) or self.workspace.is_listed(name)

    def is_public(self, name: str) -> bool:
        """Return whether a package is released, or a library that rosdep knows."""
        return self.workspace.index.is_package(name) or bool(keys_for_cmake(name))

    def must_be_of_ros(self, name: str) -> bool:
        """Return whether a name can only be that of a ROS package: no file of this package makes CMake find it."""
        modules = (f"/find{name}.cmake", f"/{name}config.cmake", f"/{name}-config.cmake")
        paths = self.cmake.package_files.paths
        return ROS_NAME.fullmatch(name) is not None and not any(f"/{p}".lower().endswith(modules) for p in paths)

    def may_be_found(self, name: str) -> bool:
        """Return whether a found package may find one of that name: it has no `_`, or not all found ones are public.

        Libraries of the system find no packages of ROS.
        """
        return "_" not in name or any(self.workspace.named(e) is not None or not self.is_public(e) for e in self.found)

    def is_found_in_other_case(self, name: str) -> bool:
        """Return whether a known package differs in case alone, which CMake may find by this spelling, too."""
        small = name.lower()
        known = self.found | self.declared | self.workspace.names
        same = {*in_other_case(name, known), *((small,) if self.workspace.index.is_package(small) else ())} - {name}
        return bool(same) and not all(map(self.workspace.is_cased, same))

    def found_library(self, name: str) -> str | None:
        """Return the library that CMake finds in another case (`PCL` for `pcl`): the variable `pcl_FOUND` is not set.

        None where a package has the name as it is written, or a file says that it is found.
        """
        cmake = self.cmake
        is_whole = cmake.is_complete and not cmake.reads_unknown_files and self.workspace.named(name) is None
        is_there = name in self.found | self.found_in_capitals or self.workspace.index.is_package(name)
        if not is_whole or is_there or any(f"{name}_FOUND" in file.source.text for file in cmake.files):
            return None
        same = [each for each in self.found if each.lower() == name.lower()]
        return same[0] if len(same) == 1 and name.upper() != name else None

    def alike(self, name: str) -> str | None:
        """Return the one found package that differs in case and underscores, or is a vendor package of the name."""
        plain = name.replace("_", "").replace("-", "").lower()
        same = {each for each in self.found if each.replace("_", "").replace("-", "").lower() == plain}
        vendors = {each for each in self.found if each.endswith("_vendor") and is_end(each, name)}
        near = same or vendors
        return near.pop() if len(near) == 1 else None


def is_end(one: str, other: str) -> bool:
    """Return whether one name is the other without its first words."""
    return one.endswith(f"_{other}") or other.endswith(f"_{one}")
