"""One install rule: what is installed, where, and with which permissions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass

Kind = Literal["TARGETS", "FILES", "PROGRAMS", "DIRECTORY", "CODE", "EXPORT"]


@dataclass(frozen=True, slots=True)
class Pattern:
    """`PATTERN "*.hpp"` or `REGEX …` of install(DIRECTORY)."""

    text: str
    is_regex: bool
    is_exclude: bool = False
    permissions: frozenset[str] = frozenset()
    """What the matching files get."""


@dataclass(frozen=True)
class InstallRule:
    kind: Kind
    items: tuple[Word, ...]
    destination: str | None
    """Relative to the prefix, absolute where it is written so; None where it is unknown."""
    call: EvaluatedCommand
    destination_word: Word | None = None
    destinations: Mapping[str, str | None] | None = None
    """Of targets: the destination of each kind of artifact."""
    rename: Word | None = None
    patterns: tuple[Pattern, ...] = ()
    matching: bool = False
    """Only files that fit a pattern are installed."""
    permissions: frozenset[str] = frozenset()
    """`USE_SOURCE_PERMISSIONS`, or what PERMISSIONS and FILE_PERMISSIONS name."""
    export: Word | None = None
    optional: bool = False
