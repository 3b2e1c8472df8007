"""A timer that keeps time only as well as a test needs."""

from __future__ import annotations

import time
from collections.abc import Callable


class Timer:
    def __init__(self, period: float, callback: Callable[[], None]) -> None:
        assert period > 0
        self.period, self.callback, self.due, self.canceled = period, callback, time.monotonic(), False

    def cancel(self) -> None:
        self.canceled = True

    def __call__(self) -> None:
        if not self.canceled and time.monotonic() >= self.due:
            self.due += self.period
            self.callback()
