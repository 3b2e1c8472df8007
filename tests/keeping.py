"""The command with its cache, in this process, and whether a run was served from it."""

from __future__ import annotations

import os
import sys
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import NamedTuple

import rospkg_cli.__main__ as entry
from rospkg_cli import disk_trace


class Run(NamedTuple):
    status: int
    out: str
    err: str
    is_served: bool


def run_kept(*arguments: object, cwd: Path, **environment: str) -> Run:
    """Run `rospkg lint` as a process would, with more variables in its environment."""
    out, err, before, argv, path = StringIO(), StringIO(), Path.cwd(), sys.argv, list(sys.path)
    variables, served, ask = dict(os.environ), [], entry.lint_as_before

    def noted(words: list[str]) -> int | None:
        served.append(ask(words))
        return served[-1]

    try:
        os.environ.update(environment, PWD=str(cwd))
        os.chdir(cwd)
        sys.argv = ["rospkg", "lint", *map(str, arguments)]
        entry.lint_as_before = noted
        with redirect_stdout(out), redirect_stderr(err):
            status = entry.main()
    finally:
        entry.lint_as_before = ask
        disk_trace.stop_trace()
        os.chdir(before)
        os.environ.clear()
        os.environ.update(variables)
        sys.argv, sys.path[:] = argv, path
    return Run(status, out.getvalue(), err.getvalue(), served[0] is not None)
