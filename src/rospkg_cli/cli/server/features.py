"""All that the server can do, put together."""

from __future__ import annotations

from .answers import offer_lookups
from .follow import follow_disk, follow_folders, follow_texts
from .language_server import PackageServer
from .offered_actions import offer_actions


def server_with_features() -> PackageServer:
    """Return a server that has not begun to listen."""
    server = PackageServer()
    for let in (follow_texts, follow_folders, follow_disk, offer_actions, offer_lookups):
        let(server)
    return server
