"""Rule input: the levels of faults in a robot description, by what opens the robot and reads the place (URD001)."""

from __future__ import annotations

import re
from typing import Annotated

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.launch.text import uncommented
from ...package.urdf.robot_file import RobotFile
from ...unreadable import READABLE
from ..fault import Fault, softer
from ..repository.older_distribution import OlderDistribution
from .control_readers import ControlReaders
from .enclosing_elements import ancestors
from .given_prefixes import gives_text
from .launched_robots import LaunchedRobots
from .lost_prefix import EMPTY, UNLESS, UNLESS_EMPTY
from .met_robots import OPENED_WHEN_ON, MetRobots
from .one_slip import is_slip
from .opened_robots import OpenedRobots
from .validation import VAIN
from .xacro_calls import XacroCalls
from .xacro_problems import STOPS
from .xacro_slips import MUST_BE_GIVEN

PREFIX = regex(r"the prefix of `\$\{\s*(\w+)")
XACRO = regex(r"(?<![\w.])xacro\b")
"""The program or the module; not the ending of a file."""
IN_GAZEBO = regex(r"(?:gazebo|gz|ign)_ros2_control/")


@dataclass(frozen=True)
class RobotLevels:
    robot: RobotFile
    calls: XacroCalls
    opened: OpenedRobots
    launched: LaunchedRobots
    met: MetRobots
    distribution: OlderDistribution
    readers: ControlReaders
    robots: Annotated[tuple[RobotFile, ...], READABLE] = ()

    def at_its_level(self, fault: Fault, robot: str) -> Fault:
        """Return a fault as an error where a launch file certainly opens a robot that meets it, else as an info.

        There is no warning: what xacro and urdfdom skip, or meet in some runs only, is seldom noticed.
        """
        is_launched = self.launched.has(robot)
        if fault.level == "info":
            return fault
        if blank := self.unless_filled_in():
            return replace(fault, level="info", message=fault.message + blank)
        if STOPS in fault.message and not self.is_surely_expanded(robot):
            return softer(fault, "info", "where xacro reads the file, which nothing here does")
        if unread := self.readers.unless_read(self.robot.document.root, fault):
            return replace(fault, level="info", message=fault.message + unread)
        if fault.level is None and is_launched:
            return softer(fault, "info", OPENED_WHEN_ON) if self.met.is_off(robot) else fault
        if VAIN in fault.message and self.distribution.is_before_jazzy and not self.is_simulated:
            return softer(fault, "info", "and stops from Jazzy on alone, which no page names")
        if MUST_BE_GIVEN in fault.message and self.may_be_given(fault):
            return replace(fault, level="info")
        if not self.met.has(robot) or (not is_launched and may_be_elsewhere(fault)):
            which = "this robot" if robot == self.robot.path else "a robot that reaches this"
            return softer(fault, "info", f"as soon as something opens {which}")
        if idle := self.unless_called(fault):
            return softer(fault, "info", idle)
        return self.without_prefix(fault) if UNLESS in fault.message else replace(fault, level="info")

    def is_surely_expanded(self, robot: str) -> bool:
        """Return whether xacro certainly reads a robot, by its name, its elements, or a text that opens it."""
        if robot.endswith(".xacro") or "xacro:" in self.robot.source.text:
            return True
        name = robot.rpartition("/")[2]
        return any(XACRO.search(text) for path, text in self.opened.texts.every if path != robot and name in text)

    def unless_filled_in(self) -> str:
        """Return the end of the message for a robot with names or values that are blanks to fill in; "" for others."""
        from .left_blanks import STILL, has_blanks  # imported for findings alone

        return STILL if has_blanks(self.robot.document.root) else ""

    def unless_called(self, fault: Fault) -> str:
        """Return why no run meets a fault: Gazebo leaves it out, or no opened robot calls its macro; else ""."""
        around = list(ancestors(self.robot.document.root, fault.span))
        blocks = (each.attributes["reference"] for each in around if each.tag == "gazebo" and each.get("reference"))
        if is_slip(fault) and any(each.value_span.holds(fault.span) for each in blocks):
            return "and Gazebo leaves out what is said of it"
        names = [each.get("name") or "" for each in around if each.tag == "xacro:macro"]
        for call in (re.compile(rf"<xacro:{re.escape(name.removeprefix('xacro:'))}(?![\w.-])") for name in names):
            callers = [each.path for each in self.robots if call.search(uncommented(".xml", each.source.text))]
            if callers and not any(map(self.met.has, callers)):
                return "as soon as something opens a robot that calls the macro"
        return ""

    def without_prefix(self, fault: Fault) -> Fault:
        """Return a lost prefix as an info, and say so if no call of the macro gives a prefix."""
        around = list(ancestors(self.robot.document.root, fault.span))
        macro = next((each for each in reversed(around) if each.tag == "xacro:macro"), None)
        parameter = PREFIX.search(fault.message)
        if macro is None or parameter is None:
            return replace(fault, level="info")
        near = self.calls.includes.including(self.robot.path.rpartition("/")[2])
        given = gives_text(macro, parameter[1], near, self.calls.includes.texts)
        said = fault.message if given is not False else fault.message.replace(UNLESS_EMPTY, EMPTY)
        return replace(fault, level="info", message=said)

    @property
    def is_simulated(self) -> bool:
        """Whether Gazebo moves joints of a `<ros2_control>`: every distribution of it ignores missing joints."""
        plugins = (each.text for each in self.robot.document.root.walk() if each.tag == "plugin")
        return any(IN_GAZEBO.match(text.strip()) for text in plugins)

    def may_be_given(self, fault: Fault) -> bool:
        """Return whether each text that opens the file may give an argument."""
        names = [each.get("name") or "" for each in ancestors(self.robot.document.root, fault.span)]
        elsewhere = any(self.calls.is_set_elsewhere(name, self.robot.document.source.text) for name in names if name)
        return elsewhere or self.is_replaced(fault) or not self.launched.has(self.robot.path)

    def is_replaced(self, fault: Fault) -> bool:
        """Return whether a fault is in a default that each launch file replaces, so that xacro never reads it."""
        defaults = (each for each in ancestors(self.robot.document.root, fault.span) if each.tag == "xacro:arg")
        return any(self.opened.arguments.has(self.robot.path, each.get("name") or "") for each in defaults)


def may_be_elsewhere(fault: Fault) -> bool:
    """Return whether a missing link may be in a file that includes this one: no link here has a similar name."""
    return fault.message.startswith("no link is called") and "did you mean" not in fault.message
