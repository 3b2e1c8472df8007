"""Where a run looks whether to go on, to make way, or to end: between files and between rules."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from threading import Event

from ...light_dataclasses import dataclass, field


class RunInterrupted(BaseException):
    """A run is not worth its end, because what it looks at has changed.

    No Exception: those are taken for faults of the rule or the reader in which they are raised.
    """


@dataclass
class RightOfWay:
    """Whether something shorter than a run goes on, for which runs wait; entered in one thread only."""

    is_free: Event = field(default_factory=Event)
    _count: int = 0

    def __post_init__(self) -> None:
        self.is_free.set()

    @contextmanager
    def taken(self) -> Iterator[None]:
        """Let runs wait at their next safe point."""
        self._count += 1
        self.is_free.clear()
        try:
            yield
        finally:
            self._count -= 1
            if not self._count:
                self.is_free.set()


@dataclass
class SafePoint:
    """Called by a run wherever it may be left alone or given up: it holds nothing there that others wait for."""

    way: RightOfWay = field(default_factory=RightOfWay)
    is_over: bool = False

    def __call__(self) -> None:
        """Wait while somebody else has the right of way; raises RunInterrupted where the run is over."""
        if not self.way.is_free.is_set():
            self.way.is_free.wait()
        if self.is_over:
            raise RunInterrupted

    def end(self) -> None:
        """Let the run end at its next safe point; from any thread."""
        self.is_over = True


def never() -> None:
    """Look for no interruption."""
