"""Rule input: the faults of a robot description, as written and as xacro expands it (URD001)."""

from __future__ import annotations

import posixpath
from collections.abc import Collection

from ...light_dataclasses import dataclass, replace
from ...package.urdf.robot_file import RobotFile
from ...source import Span
from ..fault import Fault, once_each
from .expanded_robots import ExpandedRobots
from .macro_prefix import prefix_faults
from .one_slip import is_slip, of_one_slip
from .robot_levels import RobotLevels
from .validation import robot_faults
from .xacro_problems import of_one_parameter

LEVELS = (None, "info")


@dataclass(frozen=True)
class JudgedRobot:
    levels: RobotLevels
    """The levels of the faults of one robot, which is the robot here."""
    expanded: ExpandedRobots

    @property
    def robot(self) -> RobotFile:
        return self.levels.robot

    def faults(self) -> list[Fault]:
        """Return the faults of the file as it is written, then of its expansion by xacro; each place once."""
        written = robot_faults(self.robot, self.levels.calls)
        seen = {fault.span for fault in written}
        made = self.made(seen)
        seen.update(fault.span for fault in made)
        later = prefix_faults(self.robot.document.root) if self.robot.is_xacro else ()
        own = [*written, *(fault for fault in later if fault.span not in seen)]
        weighed = [
            self.levels.at_its_level(each, self.robot.path)
            for each in own
            if each.level or not self.levels.is_replaced(each)
        ]
        return of_one_slip(of_one_parameter(once_each(sorted([*made, *weighed], key=lambda fault: fault.span))))

    def found(self) -> list[tuple[Fault, list[tuple[str, Span]]]]:
        """Return the faults, each with the same slip in later robots of the folder; without slips of earlier robots."""
        faults = self.faults()
        others = self.slips_in_folder() if any(map(is_slip, faults)) else []
        same = {id(fault): [(path, other) for path, other in others if is_same(other, fault)] for fault in faults}
        return [
            (fault, [(path, other.span) for path, other in same[id(fault)]])
            for fault in faults
            if not any(path < self.robot.path for path, _ in same[id(fault)])
        ]

    def slips_in_folder(self) -> list[tuple[str, Fault]]:
        """Return the slips of the other robots in the folder, each with the path of its file."""
        folder = posixpath.dirname(self.robot.path)
        near = (
            each
            for each in self.levels.robots
            if posixpath.dirname(each.path) == folder and each.path != self.robot.path
        )
        judged = (
            replace(self, levels=replace(self.levels, robot=each))
            for each in near
            if each.is_xacro and "{" in each.source.text
        )
        return [(each.robot.path, fault) for each in judged for fault in each.faults() if is_slip(fault)]

    def made(self, seen: Collection[Span]) -> list[Fault]:
        """Return the faults that xacro meets in the file, each place once, at the highest level among the robots."""
        found: dict[Span, Fault] = {}
        for robot, fault in self.expanded.faults_of(self.robot.path):
            if fault.span not in seen and (fault.level or not self.levels.is_replaced(fault)):
                weighed = self.levels.at_its_level(fault, robot)
                before = found.setdefault(fault.span, weighed)
                if LEVELS.index(weighed.level) < LEVELS.index(before.level):
                    found[fault.span] = weighed
        return list(found.values())


def is_same(one: Fault, other: Fault) -> bool:
    """Return whether two faults are the same slip, with the same message and level."""
    return is_slip(one) and (one.message, one.level) == (other.message, other.level)
