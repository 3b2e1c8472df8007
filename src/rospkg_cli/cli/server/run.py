"""`rospkg server`: start it, where what it needs is installed."""

from __future__ import annotations

import gc
import sys
from importlib.util import find_spec

from .. import UsageError

SWITCH = 0.0005
"""Seconds after which a run makes way for what the editor asks, a tenth of Python's own: messages pass many threads."""

MISSING = "rospkg server needs pygls: pip install 'rospkg-cli[server]'"


def serve() -> int:
    """Serve until the editor ends it; return the exit status. Raises UsageError without pygls."""
    if find_spec("pygls") is None:
        raise UsageError(MISSING)
    from .answers import offer_lookups
    from .follow import follow_disk, follow_folders, follow_texts
    from .language_server import PackageServer
    from .offered_actions import offer_actions

    gc.set_threshold(10_000, 10, 10)  # unlike a run that ends soon, a server has to give back what it read
    sys.setswitchinterval(SWITCH)
    server = PackageServer()
    for let in (follow_texts, follow_folders, follow_disk, offer_actions, offer_lookups):
        let(server)
    server.start_io()
    return 0
