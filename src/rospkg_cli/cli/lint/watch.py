"""`rospkg lint --watch`: lint again whenever something changes that lint looked at, until Ctrl-C."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO

from ...cache.kept_run import RunToKeep, set_run
from ...cache.recheck import Question, recheck
from ...current_folder import common_folder
from ...disk_trace import stop_trace
from ...user_error import UserError
from .. import UsageError
from ..streams import say
from .kept_output import writes
from .lint_options import LintOptions

CLEAR = "\x1b[2J\x1b[3J\x1b[H"
"""Clears a terminal, with what was scrolled out of it."""

SHORTEST = 0.5
"""Seconds between two looks at the files."""

SHARE = 20
"""Looking takes one part in so many of the time."""

LONGEST = 5.0
"""Seconds after which files without a notification are looked at, too: a config above the packages, say."""


LintTo = Callable[[LintOptions, IO[str]], int]
"""Lints and reports to a stream."""


def watch(options: LintOptions, lint_to: LintTo, ticks: Callable[[Path], Iterator[None]] | None = None) -> int:
    """Lint, and again after each change; return 0 when Ctrl-C ends it. Raises UsageError for options that write."""
    if writes(options):
        raise UsageError("--watch looks and changes nothing: leave out --fix, --diff, and what writes files")
    run, is_first = RunToKeep([]), True
    try:
        for _ in (ticks or moments)(common_folder(options.paths or (Path(),))):
            found = None if is_first else recheck(questions(run))
            is_first = False
            if found is not None:
                run.trace.signatures |= {question: signature for question, _, signature in found if signature}
                continue
            run.start()
            lint_once(options, lint_to, run)
    except KeyboardInterrupt:
        pass
    finally:
        set_run(None)
        stop_trace()
    return 0


def lint_once(options: LintOptions, lint_to: LintTo, run: RunToKeep) -> None:
    """Lint and report; what stops a single run is said, and waited for."""
    if sys.stdout.isatty():
        sys.stdout.write(CLEAR)
    set_run(run)
    try:
        lint_to(options, sys.stdout)
    except UserError as error:
        say(str(error))
    stop_trace()
    say("watching; Ctrl-C ends")
    sys.stdout.flush()


def questions(run: RunToKeep) -> list[Question]:
    """Return what the last run asked of the disk; an index that grew old is no change."""
    known = run.trace.signatures
    return [(text, answer, known.get(text, "")) for text, answer in run.trace.answers.items() if text[0] not in "dp"]


def moments(folder: Path) -> Iterator[None]:
    """Yield at once, and then whenever it is time to look: notified by the system where `watchfiles` is installed."""
    yield
    try:
        from watchfiles import watch as changes
    except ImportError:
        yield from pauses()
    else:
        for _ in changes(folder, rust_timeout=int(LONGEST * 1000), yield_on_timeout=True, raise_interrupt=True):
            yield


def pauses() -> Iterator[None]:
    """Yield every half second, less often where looking takes long."""
    pause = SHORTEST
    while True:
        time.sleep(pause)
        before = time.process_time()
        yield
        pause = max(SHORTEST, SHARE * (time.process_time() - before))
