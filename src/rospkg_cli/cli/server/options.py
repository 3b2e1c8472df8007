"""The options of `rospkg server`."""

from __future__ import annotations

EPILOG = "Examples:  rospkg server   (an editor starts it; docs/editors.md has the settings)"


def server() -> int:
    """Serve an editor by the Language Server Protocol, over standard input and output."""
    from .run import serve

    return serve()
