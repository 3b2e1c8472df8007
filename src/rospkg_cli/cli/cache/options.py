"""The options of `rospkg cache`."""

from __future__ import annotations

from typer import Context

HELP = "Show or clear what lint keeps of earlier runs."
EPILOG = "Examples:  rospkg cache  ·  rospkg cache clear"


def cache(context: Context) -> int:
    """Show where lint keeps what it found, and how large that is."""
    from .run import show

    return show() if context.invoked_subcommand is None else 0


def clear() -> int:
    """Remove all that lint keeps of earlier runs."""
    from .run import clear as run

    return run()
