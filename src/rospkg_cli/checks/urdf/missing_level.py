"""The level of a missing file of a robot: by its place, by what opens the robot, and by what fetches the file."""

from __future__ import annotations

from ...light_dataclasses import replace
from ..fault import Fault, softer
from ..python.blank_names import is_to_be_replaced
from ..repository.left_to_people import UNTIL_NAMED, why_left
from .met_robots import OPENED_WHEN_ON
from .missing_resource import MissingResource, wrong
from .robot_in_workspace import RobotInWorkspace

LEVELS = (None, "warning", "info")


def missing_fault(scope: RobotInWorkspace, missing: MissingResource) -> Fault:
    """Return a fault at the highest level among the places that name the missing file."""
    harm = "xacro stops here" if missing.is_include else "it is missing wherever the robot is shown"
    fault = Fault(missing.span, f"{wrong(missing, scope.package.name)}: {harm}")
    each = [scope.weighed(replace(fault, span=span)) for span in missing.spans]
    best = min(each, key=lambda one: LEVELS.index(one.level))
    if best.level != "info" and not scope.is_met:
        return softer(best, "info", "as soon as something opens this robot")
    if best.level != "info" and scope.met.is_off(scope.robot.path):
        return softer(best, "info", OPENED_WHEN_ON)
    if best.level != "info" and missing.state == "absent" and scope.is_fetched(missing):
        return softer(best, "info", "until it is fetched, as a page or a script here says")
    if best.level != "info" and (left := left_to_people(scope, missing)):
        return softer(best, "info", left)
    if best.level is None and not scope.is_installed:
        return softer(best, "info", "where the robot is read from the source: it is not installed")
    if best.level is None and missing.is_include and scope.may_be_read_as_it_is:
        return softer(best, "warning", "where xacro reads it")
    return best


def left_to_people(scope: RobotInWorkspace, missing: MissingResource) -> str:
    """Return why a missing file is left for users to add; "" for one that is not, or that xacro reads."""
    is_own = missing.package == scope.package.name and not missing.is_model
    if missing.is_include or missing.state != "absent" or missing.suggestion or not is_own:
        return ""
    text = scope.robot.source.text
    if all(is_to_be_replaced(text, each.start) for each in missing.spans):
        return UNTIL_NAMED
    return why_left(scope.files, missing.path)
