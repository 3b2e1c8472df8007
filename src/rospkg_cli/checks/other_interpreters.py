"""Python files that another interpreter than that of ROS runs: one inside of a program, or on a microcontroller."""

from __future__ import annotations

from collections.abc import Iterable

from ..languages.python.file import Import
from ..ros.imports import HOSTS, OF_HOSTS


def is_for_another_interpreter(imports: Iterable[Import]) -> bool:
    """Return whether a file imports what only another interpreter brings: rosdep installs nothing for that."""
    certain = [each for each in imports if not (each.is_optional or each.is_for_typing or each.level)]
    return any(
        each.module.partition(".")[0] in HOSTS or not OF_HOSTS.get(each.module, frozenset()).isdisjoint(each.names)
        for each in certain
    )
