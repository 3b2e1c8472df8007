"""The command with its cache, in this process, and whether a run was served from it."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import NamedTuple

from rospkg_cli import disk_trace
from rospkg_cli.__main__ import main
from rospkg_cli.cache import kept_run


class Run(NamedTuple):
    status: int
    out: str
    err: str
    is_served: bool


def run_kept(*arguments: object, cwd: Path, **environment: str) -> Run:
    """Run `rospkg lint` as a process would, with more variables in its environment."""
    out, err, before, argv, path = StringIO(), StringIO(), Path.cwd(), sys.argv, list(sys.path)
    variables, served, ask = dict(os.environ), [], kept_run.kept_run

    def noted(words: Sequence[str]) -> object:
        served.append(ask(words))
        return served[-1]

    try:
        os.environ.update(environment, PWD=str(cwd))
        os.chdir(cwd)
        sys.argv = ["rospkg", "lint", *map(str, arguments)]
        kept_run.kept_run = noted
        with redirect_stdout(out), redirect_stderr(err):
            status = main()
    finally:
        kept_run.kept_run = ask
        disk_trace.stop_trace()
        os.chdir(before)
        os.environ.clear()
        os.environ.update(variables)
        sys.argv, sys.path[:] = argv, path
    return Run(status, out.getvalue(), err.getvalue(), isinstance(served[0], tuple))
