"""Time and memory of one command, and where in the code something happened."""

from __future__ import annotations

import re
import resource
import signal
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

SECONDS = 5.0
"""CPU time that a command may take."""
MEMORY = 2**30
"""Bytes that a process may take more than it had when its work began."""
FRAME = re.compile(r'File "[^"]*/rospkg_cli/([^"]+)", line (\d+), in (\S+)')


class OvertimeError(BaseException):
    """A command took over its time; not an Exception, so that nobody takes it for a fault of a rule."""


def stop(number: int, frame: FrameType | None) -> None:
    raise OvertimeError(f"over {SECONDS:.0f} s of CPU")


@contextmanager
def limited() -> Iterator[None]:
    """Raise OvertimeError in what takes too long; a call into C is left first (the watchdog ends one that never is)."""
    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, SECONDS, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def limit_memory() -> None:
    """Let this process grow by MEMORY at most: what asks for more gets a MemoryError."""
    size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (size + MEMORY, resource.RLIM_INFINITY))


def place_of(text: str) -> str:
    """Return the last place in our code that a traceback names, and the two it came through."""
    frames = [f"{path}:{line} {name}" for path, line, name in FRAME.findall(text)]
    return " < ".join(dict.fromkeys(reversed(frames[-3:])))


def cause(error: BaseException) -> tuple[str, str]:
    """Return what was raised, and where."""
    text = "".join(traceback.format_exception(error, limit=-40))
    return f"{type(error).__name__}: {str(error)[:200]}", place_of(text)
