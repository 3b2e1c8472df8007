"""Faults of a launch file at places that launch never visits or whose value nothing reads, and why."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..fault import Fault, Level, softer_advice
from .idle_actions import NEVER_ADDED, NEVER_CALLED, OFF, UNUSED, level_read
from .launch_context import LaunchContext
from .unread_values import UnreadValues
from .who_meets import as_python_meets, why_unmet

LOST = (NEVER_ADDED, NEVER_CALLED, OFF, UNUSED)
"""Why a fault does not show in a plain launch."""
LATE: tuple[Level | None, ...] = ("warning",)
"""The level of a fault with which the launch goes on; with others Python stops where it makes the value."""


def where_met(scope: LaunchContext, faults: Iterable[Fault], late: tuple[Level | None, ...] = LATE) -> Iterator[Fault]:
    """Yield faults, as infos where no plain launch reaches them; those that are infos already as they are.

    `late` are the levels of what shows only once launch visits the action or reads the value.
    """
    for fault in faults:
        why = why_lost(scope, fault) if fault.level in late else ""
        yield softer_advice(fault, "info", why) if why else as_python_meets(scope.file, fault, scope.workspace)


def why_lost(scope: LaunchContext, fault: Fault) -> str:
    """Return why a plain launch does not reach a fault; "" where it may."""
    level, why = level_read(scope.file, fault.span)
    if level == "info" and why in LOST:
        return why
    unused = UNUSED if UnreadValues(scope).holds(fault.span) else ""
    return unused or why_unmet(scope.file, fault.span, scope.workspace)
