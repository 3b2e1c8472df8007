"""Rule input: a robot description, with what its package calls and reads of xacro."""

from __future__ import annotations

from ...light_dataclasses import dataclass, replace
from ...package.install_table import InstallTable
from ...package.urdf.robot_file import RobotFile
from ..fault import Fault, once_each, softer
from .expanded_robots import ExpandedRobots
from .macro_prefix import prefix_faults
from .opened_robots import OpenedRobots
from .validation import robot_faults
from .xacro_calls import XacroCalls, ancestors
from .xacro_problems import of_one_parameter


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
        found = of_one_parameter(once_each(sorted([*written, *made, *others], key=lambda fault: fault.span)))
        found = [self.weighed(fault) for fault in found]
        if all(fault.level for fault in found) or not self.is_idle:
            return found
        return [replace(fault, level=fault.level or "warning") for fault in found]

    def weighed(self, fault: Fault) -> Fault:
        """Return a fault, as an info where it is in a default that each launch file replaces: xacro never reads it."""
        for around in ancestors(self.robot.document.root, fault.span) if fault.level is None else ():
            name = around.get("name") or ""
            if around.tag == "xacro:arg" and self.opened.is_always_given(self.robot.path, name):
                return softer(fault, "info", f"where no `{name}:=` is given, which each launch file here gives")
        return fault
