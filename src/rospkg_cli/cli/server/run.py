"""`rospkg server`: start it, where what it needs is installed."""

from __future__ import annotations

import gc
import os
import sys
from contextlib import redirect_stdout
from importlib.util import find_spec
from typing import BinaryIO

from .. import UsageError

SWITCH = 0.0005
"""Seconds after which a run makes way for what the editor asks, a tenth of Python's own: messages pass many threads."""

COLLECTIONS = (2_000, 10, 500)
"""When Python collects garbage, which a server has to do, unlike a program that ends soon. A full collection stops all
for 0.5 s in the middle of a run (navigation2), so it is left to the moment behind one, when little is there."""

MISSING = "rospkg server needs pygls: pip install 'rospkg-cli[server]'"


def serve() -> int:
    """Serve until the editor ends it; return the exit status. Raises UsageError without pygls."""
    if find_spec("pygls") is None:
        raise UsageError(MISSING)
    from .processes import behind_front

    return behind_front(serve_here)


def serve_here() -> int:
    """Serve in this process alone."""
    from .features import server_with_features
    from .in_time import quieten
    from .shared_properties import let_threads_compute

    gc.set_threshold(*COLLECTIONS)
    sys.setswitchinterval(SWITCH)
    quieten()
    let_threads_compute()
    server = server_with_features()
    server.lints.is_alone = True
    with protocol_output() as output, redirect_stdout(sys.stderr):
        try:
            server.start_io(stdout=output)
        finally:
            for live in server.workspaces:
                live.look.end()
    return 0


def protocol_output() -> BinaryIO:
    """Return standard output for messages alone: what a rule of a plug-in prints is none."""
    return os.fdopen(os.dup(sys.stdout.fileno()), "wb")
