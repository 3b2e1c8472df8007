"""Packages that generated interfaces need where they are used: their code is loaded with that of this package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.interfaces.interface_file import InterfaceFile
from ...source import Span
from ..interfaces.package_interfaces import InterfaceGeneration


@dataclass(frozen=True, slots=True)
class InterfaceNeed:
    package: str
    path: str
    span: Span
    type: str
    """As a field names it; "" where CMake alone names the package."""


def interface_needs(interfaces: Iterable[InterfaceFile], generation: InterfaceGeneration) -> Iterator[InterfaceNeed]:
    """Yield each place that names a package: the types of fields, then what CMake generates the code with."""
    if generation.package.build_type == "ament_python":
        return
    for file in interfaces:
        for each in file.types if generation.may_read(file.path) else ():
            if each.package:
                yield InterfaceNeed(each.package, file.path, each.base_span, f"{each.package}/{each.base}")
    if generation.cmake is not None:
        yield from handed_on(generation.cmake)


def handed_on(cmake: CMake) -> Iterator[InterfaceNeed]:
    """Yield the packages that `rosidl_generate_interfaces` makes all users look for."""
    for target in cmake.interface_targets:
        for word in () if target.skip_install or target.call.testing else target.dependencies:
            if word.is_known and not word.maybe:
                yield InterfaceNeed(word.text, word.path, word.span, "")
