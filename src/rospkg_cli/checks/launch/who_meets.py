"""Whether a launch reaches a fault in a launch file: its action may be off, or every launch ends before."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...source import Span
from ..fault import Fault, Level, softer_advice
from .idle_actions import level_at
from .unmet_lookups import package_lacked, package_lacked_above

ENDS_BEFORE = "but the launch ends before, as nothing here brings the package `{}`"


@dataclass(frozen=True)
class LaunchFileAmongPackages:
    """Rule input: a launch file, and the packages that are there for it."""

    file: LaunchFile
    workspace: Workspace


def level_met(file: LaunchFile, span: Span, workspace: Workspace) -> tuple[Level | None, str]:
    """Return the level of a fault that shows when launch visits an action, None for the rule's own, and why."""
    level, why = level_at(file, span)
    lacked = package_lacked(file, span, workspace) if level != "info" else ""
    return ("info", ENDS_BEFORE.format(lacked)) if lacked else (level, why)


def why_unvisited(file: LaunchFile, span: Span, workspace: Workspace) -> str:
    """Return why no plain launch reaches a place: its action is off, or the launch ends before; "" where one may."""
    level, why = level_met(file, span, workspace)
    return why if level == "info" else ""


def why_unmet(file: LaunchFile, span: Span, workspace: Workspace) -> str:
    """Return why no launch reaches a place, as it ends before for lack of a package; "" where it may."""
    lacked = package_lacked(file, span, workspace)
    return ENDS_BEFORE.format(lacked) if lacked else ""


def as_python_meets(file: LaunchFile, fault: Fault, workspace: Workspace) -> Fault:
    """Return a fault at which Python itself stops as an info, where it stops above for lack of a package."""
    why = why_python_stops(file, fault.span, workspace) if fault.level != "info" else ""
    return softer_advice(fault, "info", why) if why else fault


def why_python_stops(file: LaunchFile, span: Span, workspace: Workspace) -> str:
    """Return why Python does not reach a line, as it stops above for lack of a package; "" where it may."""
    lacked = package_lacked_above(file, span, workspace)
    return ENDS_BEFORE.format(lacked) if lacked else ""
