"""Python files that need ROS 1, and so end at an import before anything of theirs runs."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.python.imports import Import

ROS1 = frozenset({"rospy", "roslib"})
"""Modules without which nothing of ROS 1 runs, and which ROS 2 does not have."""


def ros1_import(imports: Iterable[Import]) -> Import | None:
    """Return the first of a file's imports that needs ROS 1 and is not optional."""
    certain = (each for each in imports if not (each.is_optional or each.is_for_typing or each.is_local))
    return next((each for each in certain if each.module.partition(".")[0] in ROS1), None)
