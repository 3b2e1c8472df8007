"""What the modules of launch and launch_ros export."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import sets

EXPORTS: Mapping[str, frozenset[str]] = sets("launch_exports.txt")


def exporting_module(name: str) -> str:
    """Return the one module that a name of launch is imported from; "" for others, and for names with several."""
    found = [module for module, names in EXPORTS.items() if name in names and "parameter_descriptions" not in module]
    return found[0] if len(found) == 1 else ""
