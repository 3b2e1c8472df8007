"""IDL010 unknown-field."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.unknown_fields import FieldUses, UnknownField
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

DEPENDS = "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"
NODE = """\
import rclpy.node
from std_msgs.msg import String


class Listener(rclpy.node.Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.hear, 10)

    def hear(self, msg):
        self.get_logger().info(msg.{})
"""
TALKER = "from std_msgs.msg import String\n\n\ndef words():\n    msg = String()\n    msg.{} = 'hello'\n    return msg\n"


@rule(
    "IDL010",
    "unknown-field",
    over=FieldUses,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"package.xml": manifest(DEPENDS), "my_pkg/listener.py": NODE.format("«dat»")},
            good={"my_pkg/listener.py": NODE.format("data")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={
                "package.xml": manifest(DEPENDS.replace("rclpy", "ament_index_python")),
                "my_pkg/talker.py": TALKER.format("«datta»"),
            },
            good={"my_pkg/talker.py": TALKER.format("data")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_field(uses: FieldUses) -> Iterator[Hit]:
    """
    ## What it does
    Finds fields that Python code sets or reads and that the message does not have.
    The message of a variable is known by its assignments (`msg = Twist()`, `Drive.Feedback()`), its annotation, or the
    `create_subscription` and `create_service` that a function is registered by.

    ## Why is this bad?
    A message has slots for its own fields: any other name raises AttributeError, often only when the first message
    arrives.

    ## When it is quiet
    Where a variable may hold something else, or its type or attributes are asked for; where an AttributeError is
    caught; for what an action client is handed, a message around the feedback or result (`.feedback`), which
    annotations often take for it; for packages outside of the workspace, unless the name is near a field or was one in
    ROS 1; in files that nothing installs.

    ## Fix safety
    The intended field is a guess.
    """
    groups: dict[tuple[str, str, str], list[UnknownField]] = {}
    for found in uses.unknown():
        groups.setdefault((found.path, found.message, found.name), []).append(found)
    for first, *others in groups.values():
        fix = None
        if first.near:
            edits = tuple(Edit(each.path, each.span, first.near) for each in (first, *others))
            fix = Fix(f"write `{first.near}`", edits, Safety.UNSAFE)
        related = tuple(Related(each.path, each.span, "and here") for each in others)
        yield Hit(first.path, first.span, message(first), related=related, fix=fix)


def message(found: UnknownField) -> str:
    start = f"`{found.message}` has no field `{found.name}`"
    end = f"; did you mean `{found.near}`?" if found.near else ""
    if found.is_keyword:
        return f"{start}: Humble raises AssertionError, and later distributions pass over it{end}"
    return f"{start}{' in ROS 2' if found.is_ros1 else ''}: this raises AttributeError{end}"
