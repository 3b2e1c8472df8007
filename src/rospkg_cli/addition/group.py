"""The membership of a package in a group."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import ChangeError
from ..edits.manifest import add_element, remove_element
from ..edits.manifest_format import to_format_3
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from .dependency import manifest_of
from .part import Operations


@dataclass(frozen=True)
class GroupMember:
    name: str

    def add(self, package: Package) -> Operations:
        """Return the element, nothing where it is there; format 2 becomes 3, which all that 2 has is valid in.

        Raises ChangeError in format 1, whose tags mean other things.
        """
        manifest = manifest_of(package)
        if any(each.text == self.name for each in manifest.all("member_of_group")):
            return ()
        if manifest.format < 2:
            raise ChangeError('package.xml has no groups before format 3; write <package format="3"> first')
        newer = to_format_3(manifest) if manifest.format == 2 else ()
        return (*newer, add_element(manifest, "member_of_group", f"<member_of_group>{self.name}</member_of_group>"))

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal, nothing where the package still generates interfaces."""
        manifest, cmake = manifest_of(package), package.parts(CMake).only
        if cmake is None or not cmake.named("rosidl_generate_interfaces"):
            for each in manifest.all("member_of_group"):
                if each.text == self.name:
                    yield (remove_element(manifest, each),)
