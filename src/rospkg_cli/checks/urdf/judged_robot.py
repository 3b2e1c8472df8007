"""Rule input: a robot description, with what its package calls and reads of xacro."""

from __future__ import annotations

from ...light_dataclasses import dataclass, replace
from ...package.install_table import InstallTable
from ...package.urdf.robot_file import RobotFile
from ..fault import Fault, once_each
from .expanded_robots import ExpandedRobots
from .macro_prefix import prefix_faults
from .opened_robots import OpenedRobots
from .validation import robot_faults
from .xacro_calls import XacroCalls


@dataclass(frozen=True)
class JudgedRobot:
    robot: RobotFile
    calls: XacroCalls
    expanded: ExpandedRobots
    opened: OpenedRobots
    table: InstallTable | None = None

    @property
    def is_idle(self) -> bool:
        """Whether nothing here opens the robot: the package opens others, or does not even install this one."""
        path, table = self.robot.path, self.table
        lost = table is not None and table.knows("share") and all(row.source != path for row in table.rows)
        return not self.opened.has(path) if lost else self.opened.is_passed_over(path)

    def faults(self) -> list[Fault]:
        """Return what is wrong with the file as it is written, then with what xacro makes of it, each place once."""
        written = robot_faults(self.robot, self.calls)
        told = {fault.span for fault in written}
        made = [fault for fault in self.expanded.faults_of(self.robot.path) if fault.span not in told]
        told.update(fault.span for fault in made)
        later = prefix_faults(self.robot.document.root) if self.robot.is_xacro else ()
        others = [fault for fault in later if fault.span not in told]
        found = once_each(sorted([*written, *made, *others], key=lambda fault: fault.span))
        if all(fault.level for fault in found) or not self.is_idle:
            return found
        return [replace(fault, level=fault.level or "warning") for fault in found]
