"""`rospkg server`: start it, where what it needs is installed."""

from __future__ import annotations

from importlib.util import find_spec

from .. import UsageError

MISSING = "rospkg server needs pygls: pip install 'rospkg-cli[server]'"


def serve() -> int:
    """Serve until the editor ends it; return the exit status. Raises UsageError without pygls."""
    if find_spec("pygls") is None:
        raise UsageError(MISSING)
    from .language_server import make_server

    make_server().start_io()
    return 0
