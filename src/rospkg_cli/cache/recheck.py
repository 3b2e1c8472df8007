"""Ask the disk again what an earlier run asked, and compare the answers."""

from __future__ import annotations

import os
import time

from .. import disk_trace
from ..disk_trace import Trace
from . import own_code

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

Question = tuple[str, str, str]
"""What was asked, the answer, and the signature of the file, or ""."""


def today(_: str = "") -> str:
    return time.strftime("%Y-%m-%d", time.gmtime())


DISK: dict[str, Callable[[str], object]] = {
    "k": disk_trace.kind_of,
    "x": disk_trace.is_there,
    "t": disk_trace.link_target,
    "r": disk_trace.real_path,
    "l": disk_trace.scan,
    "n": disk_trace.names_in,
    "b": disk_trace.read_limited,
    "w": disk_trace.read,
}
"""By the letter that a question begins with."""

OTHERS: dict[str, Callable[[str], str]] = {
    "d": today,
    "o": lambda _: own_code.code_digest(),
    "p": own_code.installed_in,
}


def recheck(questions: Sequence[Question]) -> list[Question] | None:
    """Return the questions with signatures as they are now; None where one is answered differently.

    The first that differs ends it. A file whose signature is the same is not read.
    """
    trace, found = disk_trace.start_trace(), []
    try:
        for question, answer, known in questions:
            if known and signature_of(question) == known:
                found.append((question, answer, known))
                continue
            now = ask(question, trace)
            if now != answer and not is_same_source(question, answer, now):
                return None
            found.append((question, now, new_signature(question, trace)))
    finally:
        disk_trace.stop_trace()
    return found


def ask(question: str, trace: Trace) -> str:
    letter, path = question[:1], question[1:]
    if letter in OTHERS:
        return OTHERS[letter](path)
    if letter not in DISK:
        return ""
    try:  # noqa: SIM105 — contextlib is not imported yet
        DISK[letter](path)
    except (OSError, ValueError):
        pass
    return trace.answers.get(question, "")


def signature_of(question: str) -> str:
    """Return the signature that a file has now."""
    if question[:1] == "o":
        return own_code.code_signature()
    try:
        return disk_trace.look_of(os.stat(question[1:]))
    except (OSError, ValueError):
        return ""


def new_signature(question: str, trace: Trace) -> str:
    return own_code.code_signature() if question[:1] == "o" else trace.signatures.get(question, "")


def is_same_source(question: str, before: str, now: str) -> bool:
    """Return whether two listings differ only in names that are never source: editors and tools come and go."""
    if question[:1] != "l" or before[:1] == "!" or now[:1] == "!":
        return False
    from ..leftovers import is_never_source

    one, other = ([mark for mark in text.split("/") if not is_never_source(mark[1:])] for text in (before, now))
    return one == other
