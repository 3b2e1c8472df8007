"""A launch configuration that a launch file uses and nothing sets, and what is known about the use."""

from __future__ import annotations

from typing import Literal

from ...light_dataclasses import dataclass
from ...source import Span

State = Literal["undeclared", "late", "not added"]
"""`not added`: it is declared, and the launch description that the file returns does not hold the declaration."""


@dataclass(frozen=True, slots=True)
class UnsetConfiguration:
    name: str
    span: Span
    state: State
    declared: tuple[str, ...]
    """The arguments that the file declares."""
    is_passed_on: bool = False
    """Whether it is only passed on to an included file, under its own name."""
    is_lookup: bool = False
    """Whether Python looks it up in a dict."""
    may_be_included: bool = False
    """Whether a file that is included before, and is not here, may set it; none of the workspace does."""
    has_default: bool = False
    """Whether it has a default, which is what it always is."""
    is_guess: bool = False
    """Whether the use may never run, or another name may be intended."""
    is_unread: bool = False
    """Whether it is bound to a local name that nothing reads: launch never asks for it."""
    is_inherited: bool = False
    """Whether a file that includes this one sets it; `declared` is the unused argument that is probably intended."""
