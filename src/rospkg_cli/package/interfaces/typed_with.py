"""The packages whose types a package's interfaces have: whoever uses these gets them as well."""

from __future__ import annotations

from ...files import ReaderInput
from ..cmake.build import is_built_with_cmake
from ..cmake.cmake_project import CMake
from .interface_file import InterfaceFile


def typed_with(reading: ReaderInput) -> frozenset[str]:
    """Return what interfaces are generated with, by the types of fields and the DEPENDENCIES in CMake.

    rosidl exports all of that, and links the targets of the interfaces with it, whatever package.xml declares.
    """
    cmake = reading.parts(CMake).only if is_built_with_cmake(reading) else None
    targets = [each for each in cmake.interface_targets if not each.call.testing] if cmake is not None else []
    if not targets:
        return frozenset()
    words = (word for each in targets for word in each.dependencies if word.is_known and not word.maybe)
    fields = (each for file in reading.parts(InterfaceFile).good if not file.problems for each in file.types)
    return frozenset({*(word.text for word in words), *(each.package for each in fields if each.package)})
