"""The interface files that CMake passes to rosidl_generate_interfaces."""

from __future__ import annotations

from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ..cmake.interface_targets import InterfaceTarget


@dataclass(frozen=True, slots=True)
class ListedInterface:
    """One file of a call; `path` is relative to the package, None where it is elsewhere or unknown."""

    word: Word
    target: InterfaceTarget
    path: str | None
