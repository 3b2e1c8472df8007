"""Rule input: a robot description, with what its package calls and reads of xacro."""

from __future__ import annotations

from collections.abc import Iterable

from ...light_dataclasses import dataclass, replace
from ...package.urdf.robot_file import RobotFile
from ..fault import Fault, Level
from .expanded_robots import ExpandedRobots
from .macro_prefix import prefix_faults
from .validation import robot_faults
from .xacro_calls import XacroCalls


@dataclass(frozen=True)
class JudgedRobot:
    robot: RobotFile
    calls: XacroCalls
    expanded: ExpandedRobots

    def faults(self) -> list[Fault]:
        """Return what is wrong with the file as it is written, then with what xacro makes of it, each place once."""
        written = robot_faults(self.robot, self.calls)
        told = {fault.span for fault in written}
        made = [fault for fault in self.expanded.faults_of(self.robot.path) if fault.span not in told]
        told.update(fault.span for fault in made)
        later = prefix_faults(self.robot.document.root) if self.robot.is_xacro else ()
        others = [fault for fault in later if fault.span not in told]
        return once_each(sorted([*written, *made, *others], key=lambda fault: fault.span))


def once_each(faults: Iterable[Fault]) -> list[Fault]:
    """Return the faults of each kind as one: the same sentence, with the other places next to it."""
    found: dict[tuple[str, Level | None], Fault] = {}
    for fault in faults:
        key = (fault.message, fault.level)
        first = found.get(key)
        also = (*first.related, (fault.span, "here too")) if first else ()
        found[key] = replace(first, related=also) if first else fault
    return list(found.values())
