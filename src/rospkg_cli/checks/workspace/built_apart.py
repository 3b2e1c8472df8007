"""Copies of a package in folders whose names say that one of them is built at a time."""

from __future__ import annotations

import posixpath
import re

from ...lazy_regex import regex
from ..repository.distribution_names import called
from .exercise_states import are_states

STEP = regex(r"(?!ros[12])(?P<word>\D*)(?P<number>\d+).*", re.DOTALL | re.IGNORECASE)
"""A folder that is numbered: `week2`, `lab_03`, `17-publisher`; `ros1` and `ros2` are no steps."""

ROBOT = frozenset(
    "robot onboard rpi rpi4 rpi5 pi raspi raspberry raspberrypi jetson nano orin car rover drone vehicle real hardware"
    " hw physical board".split()
)
"""Words in folder names for the robot's own computer, or for the real robot."""
OPERATOR = frozenset(
    "pc laptop desktop remote host offboard station basestation workstation operator sim simulation simulated simulator"
    " gazebo gz webots isaac unity".split()
)
"""Words in folder names for the operator's computer, or for a simulation."""
WORDS = regex(r"[a-z]+[0-9]*")


def are_of_two(one: str, other: str) -> bool:
    """Return whether folders are called as being for different distributions: `humble` and `jazzy`."""
    here, there = called(one), called(other)
    return bool(here) and bool(there) and here.isdisjoint(there)


def are_of_two_machines(one: str, other: str) -> bool:
    """Return whether two paths differ first in folders for a robot and for what is none: `pi/a` and `laptop/a`."""
    here, there = one.split("/"), other.split("/")
    shared = len(posixpath.commonprefix([here, there]))
    if min(len(here), len(there)) < shared + 2:
        return False
    first, second = (frozenset(WORDS.findall(parts[shared].lower())) for parts in (here, there))
    if not first.isdisjoint(second):
        first, second = first - second, second - first
    return any(not a.isdisjoint(ROBOT) and not b.isdisjoint(OPERATOR) for a, b in ((first, second), (second, first)))


def are_steps(one: str, other: str) -> bool:
    """Return whether two folders differ first in the number of a step: `week1/a` and `week2/a`, `17-a` and `21-b/a`.

    A number at the end of a package's own folder is that of a copy (`a`, `a2`), not of a step.
    """
    here, there = one.split("/"), other.split("/")
    shared = len(posixpath.commonprefix([here, there]))
    steps = [STEP.fullmatch(parts[shared]) if len(parts) > shared else None for parts in (here, there)]
    first, second = steps
    if first is None or second is None or first["word"] != second["word"] or first["number"] == second["number"]:
        return False
    return not first["word"] or all(len(parts) > shared + 1 for parts in (here, there))


def why_apart(one: str, other: str) -> str:
    """Return a clause on why two folders are built apart, by their names; "" where these say nothing of it."""
    if are_steps(one, other):
        return "; their folders are numbered as steps, of which one is built at a time"
    if are_states(one, other):
        return "; their folders are called as the task and the solution of an exercise, of which one is built at a time"
    if are_of_two_machines(one, other):
        return "; their folders are called as for a robot and for what is none: each is built for itself"
    return ""
