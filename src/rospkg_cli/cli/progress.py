"""Show the progress of a long run: one line on stderr, on a terminal only, after a second."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from ..control_characters import visible

if TYPE_CHECKING:
    from rich.status import Status
    from rich.text import Text

DELAY = 1.0


class ProgressLine:
    """The line of progress; until it is shown, the last text is kept."""

    def __init__(self) -> None:
        self.text = ""
        self.shown: Status | None = None
        self.over = False
        from threading import Lock

        self.lock = Lock()

    def say(self, text: str) -> None:
        with self.lock:
            self.text = text
            if self.shown:
                self.shown.update(plain_text(text))

    def show(self) -> None:
        from rich.console import Console
        from rich.status import Status

        with self.lock:
            if not self.over:
                self.shown = Status(plain_text(self.text), console=Console(stderr=True))
                self.shown.start()

    def stop(self) -> None:
        with self.lock:
            self.over = True
            if self.shown:
                self.shown.stop()


def plain_text(text: str) -> Text:
    """Return a text in which rich finds no markup."""
    from rich.text import Text

    return Text(visible(text))


@contextmanager
def progress(wanted: bool = True) -> Iterator[Callable[[str], None]]:
    """Give a function that shows the text of a step; nothing is shown where stderr is no terminal."""
    if not wanted or not sys.stderr.isatty():
        yield lambda text: None
        return
    from threading import Timer

    line = ProgressLine()
    timer = Timer(DELAY, line.show)
    timer.daemon = True
    timer.start()
    try:
        yield line.say
    finally:
        timer.cancel()
        line.stop()
