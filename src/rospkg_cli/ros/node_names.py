"""Names of the nodes that everybody gives parameters to."""

from __future__ import annotations

from .read_table import rows

TABLE = "node_names.txt"


def known_nodes() -> dict[str, tuple[str, ...]]:
    """Return the names of the nodes of well-known packages, with these packages."""
    return rows(TABLE)
