"""An argument that a command of CMake or ament refuses, or takes for something else than is intended (CMK123)."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass


@dataclass(frozen=True)
class RefusedArgument:
    call: EvaluatedCommand
    word: Word | None
    """The wrong argument; None where one is missing."""
    message: str
    is_idle: bool = False
    """Whether nothing fails as the package is built by default."""
    others: tuple[Word, ...] = ()
    """More words of the call with the same fault."""
    is_linked: bool = False
    """Whether a build with `--symlink-install` takes the words as they are intended."""
