"""What a stranger's template may use up: memory, time and length, so that none of them ends the machine."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

from jinja2 import Environment
from jinja2.filters import do_round
from jinja2.sandbox import SandboxedEnvironment

from . import OwnFaultError, ScaffoldError

try:
    import resource
except ImportError:  # not on Windows
    resource = None  # type: ignore[assignment]

CPU_SECONDS = 10.0
"""Of the processor; what we write ourselves takes less than one."""

MEMORY = 512_000_000
"""Bytes, on top of what is already in use."""

MAX_TEXT = 1_000_000
"""Characters of one file, of its source, and of what is made by multiplying."""

MAX_FILES = 1_000

MAX_BITS = 4_096
"""Of a number."""


class TookTooLongError(BaseException):
    """The time is over; no `except Exception` keeps it from the top."""


@contextmanager
def bounded() -> Iterator[None]:
    """Bound time and memory of what is done inside; raises OwnFaultError.

    Time only in the main thread, memory only where /proc shows what is used.
    """
    try:
        with bounded_memory(), bounded_time():
            yield
    except TookTooLongError:
        raise OwnFaultError(f"it takes more than {CPU_SECONDS:g} seconds; is there a loop within loops?") from None
    except MemoryError:
        raise OwnFaultError(f"it needs more than {MEMORY // 1_000_000} MB of memory") from None


@contextmanager
def bounded_time() -> Iterator[None]:
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, CPU_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def stop(number: int, frame: FrameType | None) -> NoReturn:
    raise TookTooLongError


@contextmanager
def bounded_memory() -> Iterator[None]:
    used = memory_used()
    if resource is None or used is None:
        yield
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = min(each for each in (used + MEMORY, soft, hard) if each != resource.RLIM_INFINITY)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def memory_used() -> int | None:
    """Return the size of the process's address space in bytes; None where /proc does not tell."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    except (OSError, AttributeError):
        return None


class BoundedEnvironment(SandboxedEnvironment):
    """A sandbox in which no single step takes for ever: those can't be stopped from outside."""

    intercepted_binops = frozenset({"*", "**"})

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        for name in ("striptags", "urlize", "xmlattr"):  # regular expressions that are slow on hostile text
            del self.filters[name]
        del self.globals["lipsum"]
        self.filters["round"] = round_to

    def call_binop(self, context: Any, operator: str, left: Any, right: Any) -> Any:
        bits = [each.bit_length() if isinstance(each, int) else 0 for each in (left, right)]
        if operator == "**" and isinstance(left, int) and isinstance(right, int) and bits[0] * abs(right) > MAX_BITS:
            raise OverflowError(f"a number would have more than {MAX_BITS} bits")
        if operator == "*" and max(product_sizes(left, right)) > MAX_TEXT:
            raise OverflowError(f"a text or a list would be longer than {MAX_TEXT:,}")
        if operator == "*" and sum(bits) > MAX_BITS:
            raise OverflowError(f"a number would have more than {MAX_BITS} bits")
        return super().call_binop(context, operator, left, right)


def product_sizes(left: Any, right: Any) -> Iterator[int]:
    yield 0
    for many, times in ((left, right), (right, left)):
        if isinstance(times, int) and isinstance(many, str | bytes | list | tuple):
            yield len(many) * times


def round_to(value: float, precision: int = 0, method: Any = "common") -> float:
    if abs(precision) > 20:
        raise OverflowError("round takes at most 20 digits")
    return do_round(value, precision, method)


def text_of(environment: Environment, source: str, values: dict[str, Any], name: str = "") -> str:
    """Return what a source makes of the answers; `name` is that of a file, in the place of `source`."""
    pieces, length = [], 0
    try:
        template = environment.get_template(name) if name else environment.from_string(source)
    except RecursionError:
        raise OwnFaultError(f"{name or 'template.toml'} is nested too deeply") from None
    for piece in template.generate(values):
        length += len(piece)
        if length > MAX_TEXT:
            raise ScaffoldError(f"{name or 'a line of template.toml'} writes more than {MAX_TEXT:,} characters")
        pieces.append(piece)
    return "".join(pieces)
