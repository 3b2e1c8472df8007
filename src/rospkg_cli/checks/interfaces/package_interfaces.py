"""Rule inputs: interface files, with what generates code of them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import is_set_aside
from ...package.interfaces.interface_file import InterfaceFile
from ...package.package_facts import PackageFacts


@dataclass(frozen=True)
class InterfaceGeneration:
    """What `rosidl_generate_interfaces` of a package lists."""

    package: PackageFacts
    cmake: CMake | None

    def may_read(self, path: str) -> bool:
        """Return whether it may list a file; an unknown list is not taken to hold what is laid aside (`old/`)."""
        if self.cmake is None:
            return self.package.build_type != "ament_python"
        if not self.calls_rosidl:
            return False
        return path in self.cmake.generated_interfaces or not (self.cmake.knows_interfaces or is_set_aside(path))

    @cached_property
    def calls_rosidl(self) -> bool:
        """Whether anything may generate interfaces: a call does, or package.xml names a part of rosidl."""
        cmake = self.cmake
        if cmake is None or cmake.interface_targets or "rosidl_interface_packages" in self.package.groups:
            return True
        needs = {each.name for each in self.package.dependencies}
        return any("rosidl" in name for name in needs) or any("rosidl" in each.name for each in cmake.unreachable)

    def surely_reads(self, path: str) -> bool:
        """Return whether it lists a file under no condition; a package without CMake files is taken to do so."""
        return self.cmake is None or self.cmake.generated_interfaces.get(path, False)


@dataclass(frozen=True)
class InterfaceInPackage:
    interface: InterfaceFile
    generation: InterfaceGeneration


@dataclass(frozen=True)
class PackageInterfaces:
    interfaces: tuple[InterfaceFile, ...]
    generation: InterfaceGeneration

    def read(self) -> Iterator[InterfaceFile]:
        """Yield the files that may be read."""
        return (each for each in self.interfaces if self.generation.may_read(each.path))

    def is_variant(self, interface: InterfaceFile) -> bool:
        """Return whether other folders hold a file of the same name, of which CMake generates one under a condition."""
        return interface.path in self.variants

    @cached_property
    def variants(self) -> frozenset[str]:
        alike: dict[tuple[str, str], list[str]] = {}
        for each in self.interfaces:
            if not self.generation.surely_reads(each.path):
                alike.setdefault((each.name, each.kind), []).append(each.path)
        return frozenset(path for paths in alike.values() if len(paths) > 1 for path in paths)
