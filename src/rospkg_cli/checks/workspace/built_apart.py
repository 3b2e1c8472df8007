"""Copies of a package in folders whose names say that one of them is built at a time."""

from __future__ import annotations

import posixpath
import re

from ...lazy_regex import regex
from ..older_distribution import called

STEP = regex(r"(?!ros[12])(?P<word>\D*)(?P<number>\d+).*", re.DOTALL | re.IGNORECASE)
"""A folder that is numbered: `week2`, `lab_03`, `17-publisher`; `ros1` and `ros2` are no steps."""


def are_of_two(one: str, other: str) -> bool:
    """Return whether folders are called as being for different distributions: `humble` and `jazzy`."""
    here, there = called(one), called(other)
    return bool(here) and bool(there) and here.isdisjoint(there)


def are_steps(one: str, other: str) -> bool:
    """Return whether two folders differ first in the number of a step: `week1/a` and `week2/a`, `17-a` and `21-b/a`.

    A number at the end of a package's own folder tells of a copy (`a`, `a2`), no step.
    """
    here, there = one.split("/"), other.split("/")
    shared = len(posixpath.commonprefix([here, there]))
    steps = [STEP.fullmatch(parts[shared]) if len(parts) > shared else None for parts in (here, there)]
    first, second = steps
    if first is None or second is None or first["word"] != second["word"] or first["number"] == second["number"]:
        return False
    return not first["word"] or all(len(parts) > shared + 1 for parts in (here, there))
