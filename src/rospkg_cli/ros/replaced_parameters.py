"""Which parameters of a YAML file the launch files of well-known packages replace by their arguments."""

from __future__ import annotations

from .read_table import rows

TABLE = "replaced_parameters.txt"


def replacing_argument(package: str, path: str, node: str, parameter: str) -> str | None:
    """Return the argument by which a launch file replaces a parameter of a node; None where it does not.

    `path` is that in the share directory.
    """
    words = rows(TABLE).get(f"{package}/{path}", ())
    found = (word.removeprefix(f"{node}.{parameter}=") for word in words if word.startswith(f"{node}.{parameter}="))
    return next(found, None)


def replaces_for(package: str) -> bool:
    """Return whether all launch files of a package that replace something are known."""
    return any(name.startswith(f"{package}/") for name in rows(TABLE))
