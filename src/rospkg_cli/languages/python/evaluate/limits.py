"""The bounds of an evaluation, and how a statement ends."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from enum import Enum, auto

MAX_STEPS = 200_000
"""Expressions and statements that one file may cost: some tenths of a second."""

MAX_ITEMS = 20_000
MAX_TEXT = 1_000_000
MAX_CALLS = 25
"""How deep functions of the file may call each other."""


class LimitError(Exception):
    """The evaluation takes too long, or something in it grows too large."""


STEP = 100
"""What an expression or a statement costs; a character that is made costs 1, and so all of them have a bound too."""

ITEM = 10
"""What it costs to look at an item, or to hand it on."""

MAX_COST = MAX_STEPS * STEP


class CostMeter:
    """What an evaluation has cost so far."""

    def __init__(self) -> None:
        self.cost = 0

    @contextmanager
    def running(self) -> Iterator[None]:
        """Charge this evaluation for what is spent inside."""
        before = RUNNING.set(self)
        try:
            yield
        finally:
            RUNNING.reset(before)


RUNNING: ContextVar[CostMeter | None] = ContextVar("RUNNING", default=None)


def spend(cost: int) -> None:
    """Charge the evaluation that runs for what is done or built; raises LimitError where that is too much in all.

    Outside of an evaluation nothing is charged: there only the bounds of each operation hold.
    """
    meter = RUNNING.get()
    if meter is not None:
        meter.cost += cost
        if meter.cost > MAX_COST:
            meter.cost = MAX_COST + 1
            raise LimitError(f"it takes more than {MAX_STEPS:,} steps or {MAX_COST:,} characters")


class Flow(Enum):
    """How a statement ends."""

    NEXT = auto()
    MAYBE = auto()
    """Perhaps it went on, perhaps it left the loop or the function: what follows may not happen."""
    BREAK = auto()
    CONTINUE = auto()
    RETURN = auto()
    RAISE = auto()
