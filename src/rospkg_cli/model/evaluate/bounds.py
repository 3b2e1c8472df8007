"""The bounds of an evaluation, and how a statement ends."""

from __future__ import annotations

from enum import Enum, auto

MAX_STEPS = 200_000
"""Expressions and statements that one file may cost: some tenths of a second."""

MAX_ITEMS = 20_000
MAX_TEXT = 1_000_000
MAX_CALLS = 25
"""How deep functions of the file may call each other."""


class LimitError(Exception):
    """The evaluation takes too long, or something in it grows too large."""


class Flow(Enum):
    """How a statement ends."""

    NEXT = auto()
    MAYBE = auto()
    """Perhaps it went on, perhaps it left the loop or the function: what follows may not happen."""
    BREAK = auto()
    CONTINUE = auto()
    RETURN = auto()
    RAISE = auto()
