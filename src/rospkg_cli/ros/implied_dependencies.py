"""Dependencies that imply others, which need not be declared as well."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from .read_table import sets

TABLE = "implied_dependencies.txt"

IN_LAUNCH_FILES: Mapping[str, frozenset[str]] = sets(TABLE, "launch files")
IN_TESTS: Mapping[str, frozenset[str]] = {**IN_LAUNCH_FILES, **sets(TABLE, "tests")}
IN_CMAKE: Mapping[str, frozenset[str]] = sets(TABLE, "CMake")
"""Build tools that find others for whoever finds them."""
IN_SOURCES: Mapping[str, frozenset[str]] = sets(TABLE, "sources")
"""What C++ includes because macros and headers of another package ask for it."""
IN_PARAMETERS: Mapping[str, frozenset[str]] = sets(TABLE, "parameters")
"""What comes with a package for whoever names plugins in parameters."""

LAUNCH = IN_LAUNCH_FILES["ros2launch"]
"""What a launch file is made of; `ros2launch` brings it all."""

NAVIGATION = IN_PARAMETERS["navigation2"]


def implied_by(names: Iterable[str], table: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """Return what some dependencies imply, by one of the tables."""
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        new = table.get(waiting.pop(), frozenset()) - found
        found |= new
        waiting += new
    return frozenset(found)
