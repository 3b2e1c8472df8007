"""The interface files that CMake passes to rosidl_generate_interfaces."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ..cmake.components import InterfaceTarget


@dataclass(frozen=True, slots=True)
class ListedInterface:
    """One file of a call; `path` is relative to the package, None where it is elsewhere or unknown."""

    word: Word
    target: InterfaceTarget
    path: str | None


def listed_path(word: Word, target: InterfaceTarget) -> str | None:
    """Return the path of a listed file; an absolute one has a `:` where its own part begins."""
    text = word.text
    if text.startswith("/") and ":" in text:
        base, _, own = text.rpartition(":")
        text = f"{base}/{own}"
    return path_in_package(text, target.call.folder) if word.is_known else None
