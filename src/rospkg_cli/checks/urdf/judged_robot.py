"""Rule input: a robot description, with what its package calls and reads of xacro."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.urdf.robot_file import RobotFile
from ..fault import Fault
from .validation import robot_faults
from .xacro_calls import XacroCalls


@dataclass(frozen=True)
class JudgedRobot:
    robot: RobotFile
    calls: XacroCalls

    def faults(self) -> list[Fault]:
        return robot_faults(self.robot, self.calls)
