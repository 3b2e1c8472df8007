"""`rospkg server`: start it, where what it needs is installed."""

from __future__ import annotations

import gc
from importlib.util import find_spec

from .. import UsageError

MISSING = "rospkg server needs pygls: pip install 'rospkg-cli[server]'"


def serve() -> int:
    """Serve until the editor ends it; return the exit status. Raises UsageError without pygls."""
    if find_spec("pygls") is None:
        raise UsageError(MISSING)
    from .answers import offer_lookups
    from .language_server import PackageServer, offer_actions, watch_texts

    gc.set_threshold(10_000, 10, 10)  # unlike a run that ends soon, a server has to give back what it read
    server = PackageServer()
    for let in (watch_texts, offer_actions, offer_lookups):
        let(server)
    server.start_io()
    return 0
