"""A call of a removed command (CMK005), and what to write for each of its arguments."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import CMakeFile
from ...languages.cmake.syntax import CommandArgument, CommandInvocation
from ...light_dataclasses import dataclass
from .link_keywords import Signature


@dataclass(frozen=True)
class RemovedCommand:
    """One place where the command is written, with every run of it."""

    file: CMakeFile
    command: CommandInvocation
    calls: tuple[EvaluatedCommand, ...]


@dataclass(frozen=True)
class ReplacedArgument:
    """An argument, and what to write for it: None leaves it, nothing takes it out."""

    argument: CommandArgument
    texts: tuple[str, ...] | None = None


@dataclass(frozen=True)
class Replacement:
    parts: tuple[ReplacedArgument, ...]
    signature: Signature
    keyword: str
    """The keyword that the command has; "" where it has none."""
    includes: tuple[str, ...]
    guessed: tuple[str, ...]
    """Packages of which it is unknown whether they export targets."""
