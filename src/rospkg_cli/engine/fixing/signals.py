"""Writing that a signal can end and still leaves nothing half done."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

ENDING = (signal.SIGINT, signal.SIGTERM, *([signal.SIGHUP] if hasattr(signal, "SIGHUP") else []))


class StoppedError(BaseException):
    """A signal that ends the program, once what was begun is taken back."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


@contextmanager
def stopped_by_signals() -> Iterator[None]:
    """Let Ctrl-C, SIGTERM and SIGHUP raise StoppedError in the block; only the main thread can do so."""
    with handled_by(stop, ENDING):
        yield


@contextmanager
def signals_ignored() -> Iterator[None]:
    """Let no signal end what must come to its end."""
    with handled_by(signal.SIG_IGN, ENDING):
        yield


def stop(number: int, frame: FrameType | None) -> None:
    raise StoppedError(number)


@contextmanager
def handled_by(handler: object, numbers: tuple[signal.Signals, ...]) -> Iterator[None]:
    """Have a handler for some signals in the block; those that are ignored from outside (nohup) stay so."""
    before = {}
    import threading

    if threading.current_thread() is threading.main_thread():
        before = {number: signal.getsignal(number) for number in numbers}
    taken = {number: old for number, old in before.items() if old not in (signal.SIG_IGN, None)}
    for number in taken:
        signal.signal(number, handler)  # type: ignore[arg-type]
    try:
        yield
    finally:
        for number, old in taken.items():
            signal.signal(number, old)
