"""What will be there later."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Future:
    def __init__(self) -> None:
        self._result: Any = None
        self._done = False
        self._callbacks: list[Callable[[Future], object]] = []

    def add_done_callback(self, callback: Callable[[Future], object]) -> None:
        self._callbacks.append(callback)
        if self._done:
            callback(self)

    def set_result(self, result: object) -> None:
        self._result, self._done = result, True
        for callback in self._callbacks:
            callback(self)

    def result(self) -> Any:
        return self._result
