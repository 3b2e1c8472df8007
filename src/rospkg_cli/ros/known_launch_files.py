"""What the launch files of well-known packages take from those that include them."""

from __future__ import annotations

from .read_table import rows

TABLE = "launch_arguments.txt"


def known_arguments(package: str, path: str) -> frozenset[str]:
    """Return what a launch file takes on any supported distribution; nothing of an unknown one.

    `path` is that in the share directory.
    """
    return frozenset(rows(TABLE).get(f"{package}/{path}", ()))
