"""The packages that every machine of ROS has: what `ros_base` brings."""

from __future__ import annotations

from functools import cache

from .read_table import rows

RUNTIME = "runtime_dependencies.txt"
CORE = "ros_base"


@cache
def core_packages() -> frozenset[str]:
    """Return them, those alone that come on each distribution (a `?` in the table says otherwise)."""
    table, found, waiting = rows(RUNTIME), {CORE}, [CORE]
    while waiting:
        new = [need for need in table.get(waiting.pop(), ()) if need not in found and not need.startswith("?")]
        found.update(new)
        waiting += new
    return frozenset(found)
