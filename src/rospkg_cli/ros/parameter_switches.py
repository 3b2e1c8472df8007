"""Parameters of well-known packages that do nothing while another one, their switch, is false."""

from __future__ import annotations

from collections.abc import Iterator

from .read_table import rows

TABLE = "switches.txt"
ALL = "*"


def switches_of(package: str, name: str) -> Iterator[tuple[str, bool]]:
    """Yield the full names of the switches of a parameter, and whether each is that of its whole group.

    What stands before the parameter, as the name of its plugin, stands before its switch.
    """
    before, dot, _ = name.rpartition(".")
    for word in rows(TABLE).get(package, ()):
        switch, _, switched = word.partition("=")
        if switched == ALL and dot:
            yield f"{before}.{switch}", True
        for each in switched.split(","):
            if name == each or name.endswith(f".{each}"):
                yield name.removesuffix(each) + switch, False
