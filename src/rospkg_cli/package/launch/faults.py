"""What is wrong with a launch file, as it is read: each a plain value with its place."""

from __future__ import annotations

from dataclasses import dataclass

from ...source import Span


@dataclass(frozen=True, slots=True)
class Fault:
    """Something that the frontend refuses, or that fails for certain when the file runs."""

    span: Span
    message: str


@dataclass(frozen=True, slots=True)
class OldSyntax:
    """One place that only ROS 1 understands."""

    span: Span
    old: str
    new: str
    """What stands for it in ROS 2; "" where nothing does."""
    name: Span | None = None
    """Where the name alone stands, if another one is all that it takes."""
    now: str = ""
    """The other name."""


@dataclass(frozen=True, slots=True)
class RemovedArgument:
    span: Span
    """Of the name."""
    name: str
    now: str
    """What took its place."""
    twice: bool = False
    """Whether that one is given as well."""
