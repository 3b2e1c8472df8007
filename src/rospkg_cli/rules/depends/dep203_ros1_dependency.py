"""DEP203 ros1-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.unknown_dependencies import DependencyNames
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...ros.aliases import successors
from ...rule import rule


@rule(
    "DEP203",
    "ros1-dependency",
    over=DependencyNames,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"package.xml": manifest("  <exec_depend>«rospy»</exec_depend>\n")},
            good={"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n")},
        ),
        Example(
            bad={"package.xml": manifest("  <exec_depend>«rospy»</exec_depend>\n")},
            good={
                "package.xml": manifest('  <exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>\n'),
            },
        ),
    ),
)
def ros1_dependency(names: DependencyNames) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that exist only in ROS 1, such as `rospy`, `catkin`, `message_generation`.
    Those whose condition excludes ROS 2 are left alone.

    ## Why is this bad?
    `rosdep install` ends with "Cannot locate rosdep definition for [rospy]".
    """
    for each in names.active():
        taken = successors(each.name)
        if taken is None or names.declared.workspace.named(each.name) is not None:
            continue
        instead = " or ".join(f"`{name}`" for name in taken)
        todo = f"in ROS 2 it is {instead}" if taken else "ROS 2 has no replacement: remove the line"
        message = (
            f'`{each.name}` is a package of ROS 1: `rosdep install` ends with "Cannot locate rosdep definition for '
            f'[{each.name}]"; {todo} (or add condition="$ROS_VERSION == 1")'
        )
        path = names.declared.manifest.path
        related = tuple(Related(path, other.span, "and here") for other in names.repeated(each))
        yield Hit(path, each.span, message, related=related)
