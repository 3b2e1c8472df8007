"""Standard output and standard error: closed, on a full disk, a pipe without a reader, a poor encoding.

Imports nothing that an interpreter has not loaded at its start: a lone --version comes through here.
"""

from __future__ import annotations

import errno
import io
import os
import sys

TYPE_CHECKING = False  # typing's own would cost a start some milliseconds
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import IO, Any, TextIO

SIGPIPE = 141
"""What a shell calls the exit status of a command that SIGPIPE ended: 128 and the number of the signal."""


class OutputError(Exception):
    """What was to be printed can't be; `cause` says why. (No OSError: click takes those for its own.)"""

    def __init__(self, cause: OSError) -> None:
        super().__init__(f"can't write to standard output: {cause.strerror or cause}")
        self.cause = cause


class Output(io.TextIOWrapper):
    """Standard output; raises OutputError where it can't be written to, so that no other fault is taken for it."""

    def write(self, text: str) -> int:
        try:
            return super().write(text)
        except OSError as error:
            raise OutputError(error) from None

    def flush(self) -> None:
        try:
            super().flush()
        except OSError as error:
            raise OutputError(error) from None


class Talk(io.TextIOWrapper):
    """Standard error; what can't be written there is dropped."""

    def write(self, text: str) -> int:
        try:
            return super().write(text)
        except OSError:
            mute(self)
            return len(text)

    def flush(self) -> None:
        try:
            super().flush()
        except OSError:
            mute(self)


def guarded(work: Callable[[], int]) -> int:
    """Return the exit status of some work, or 2 where its output can't be written, 141 where the reader is gone."""
    prepare()
    try:
        status = work()
        sys.stdout.flush()
    except OutputError as lost:
        status = output_lost(lost)
    sys.stderr.flush()
    return status


def prepare() -> None:
    """Prepare the streams for every character and for errors; closed ones write to /dev/null."""
    if None in (sys.stdin, sys.stdout, sys.stderr):
        fill()
    sys.stdin = sys.stdin or open(os.devnull, encoding="utf-8")  # noqa: SIM115, PTH123
    sys.stdout = fitted(sys.stdout, sys.__stdout__, Output)
    sys.stderr = fitted(sys.stderr, sys.__stderr__, Talk)


def fill() -> None:
    """Open the descriptors 0, 1 and 2 that are closed, so that no file of a package gets one of them."""
    number = os.open(os.devnull, os.O_RDWR)
    while number <= 2:
        os.set_inheritable(number, True)
        number = os.open(os.devnull, os.O_RDWR)
    os.close(number)


def fitted(stream: Any, own: Any, kind: type[io.TextIOWrapper]) -> Any:
    """Return a stream in which a character that its encoding lacks is shown, not refused."""
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8", errors="backslashreplace")  # noqa: PTH123
    if not isinstance(stream, io.TextIOWrapper):
        return stream
    errors = "backslashreplace" if stream.errors in ("strict", "surrogateescape") else stream.errors
    if stream is not own or isinstance(stream, kind):
        stream.reconfigure(errors=errors)
        return stream
    return kind(
        stream.buffer, stream.encoding, errors, line_buffering=stream.line_buffering, write_through=stream.write_through
    )


def output_lost(lost: OutputError, more: str = "") -> int:
    """Say why nothing can be printed; return the exit status."""
    mute(sys.stdout)
    if lost.cause.errno == errno.EPIPE:
        return SIGPIPE
    say(f"{lost}{more}")
    return 2


def afterwards(show: Callable[[], None], done: str) -> None:
    """Print what was done. Where that can't be, it was done all the same: a sentence says so, and nothing fails."""
    try:
        show()
        sys.stdout.flush()
    except OutputError as lost:
        output_lost(lost, f"; {done}")


def can_encode(stream: TextIO, text: str) -> bool:
    """Return whether a stream's encoding has all characters of a text."""
    try:
        text.encode(stream.encoding or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def mute(stream: IO[str]) -> None:
    """Send what a stream still holds, and all that follows, to /dev/null."""
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
    except (OSError, ValueError):  # no stream of the system's
        pass


said: list[str] = []
"""The sentences that were printed on stderr so far."""


def say(sentence: str) -> None:
    """Print a sentence on stderr, on one line that nothing in it can break."""
    from ..control_characters import visible

    said.append(sentence)
    print(f"rospkg: {visible(sentence)}", file=sys.stderr)
