"""Python files that another interpreter than that of ROS runs: one inside of a program, or on a microcontroller."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.python.imports import Import
from ...ros.imports import HOSTS, OF_HOSTS


def is_for_another_interpreter(imports: Iterable[Import]) -> bool:
    """Return whether a file imports what only another interpreter brings: rosdep installs nothing for that."""
    return bool(host_of(imports))


def host_of(imports: Iterable[Import]) -> str:
    """Return the first module that only another interpreter brings; "" where none is imported for certain."""
    for each in imports:
        top = each.module.partition(".")[0]
        is_hosts = top in HOSTS or not OF_HOSTS.get(top, frozenset()).isdisjoint(taken(each))
        if is_hosts and not (each.is_optional or each.is_for_typing or each.level):
            return top
    return ""


def taken(each: Import) -> Iterable[str]:
    """Return what an import takes out of the top of its module."""
    inner = each.module.split(".")[1:2]
    return inner or each.names
