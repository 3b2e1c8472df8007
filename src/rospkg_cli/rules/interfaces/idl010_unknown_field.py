"""IDL010 unknown-field."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.enumeration import in_ticks
from ...checks.interfaces.field_faults import together
from ...checks.interfaces.field_uses import FieldUses
from ...checks.interfaces.seldom_fields import NEVER, worst_first
from ...checks.interfaces.unknown_fields import UnknownField
from ...example import Example, manifest, scripts, setup_py
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

TALKS, LISTENS = (setup_py(scripts(f"{each} = my_pkg.{each}:main")) for each in ("talker", "listener"))
DEPENDS = "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"
NODE = """\
import rclpy
import rclpy.node
from std_msgs.msg import String


class Listener(rclpy.node.Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.hear, 10)

    def hear(self, msg):
        self.get_logger().info(msg.{})


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
TALKER = "from std_msgs.msg import String\n\n\ndef main():\n    msg = String()\n    msg.{} = 'hello'\n    print(msg)\n"


@rule(
    "IDL010",
    "unknown-field",
    over=FieldUses,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a condition stands on the way to it, who calls it catches that, only a test runs it, it is "
        "in a program that nothing starts, though others are started, or a message is made with it and the pages "
        "do not say that the package is for Humble or older alone",
        Severity.INFO: "it is in a branch of its function, or after another exception, an annotation alone says what "
        "it is of, no way from a program to it is shown, or several conditions stand on it, nothing starts or imports "
        "the module, calls the method, or leads to the function, it stands behind `rclpy.spin`, a switch turns it off, "
        "its object is never used, its class is defined again, or a message is made with it and the pages name Jazzy "
        "or newer alone, or nothing spins the node, or the run ends before, at another fault or in a loop",
    },
    examples=(
        Example(
            bad={"setup.py": LISTENS, "package.xml": manifest(DEPENDS), "my_pkg/listener.py": NODE.format("«dat»")},
            good={"my_pkg/listener.py": NODE.format("data")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={
                "setup.py": TALKS,
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
    It also reports messages that are made with positional values (`Point(1.0, 2.0)`), which only ROS 1 accepted.
    The message of a variable is known by its assignments (`msg = Twist()`, `Drive.Feedback()`), its annotation, or the
    `create_subscription`, `create_service` and `goal_callback` that a function is registered by.

    ## Why is this bad?
    A message has slots for its own fields: any other name raises AttributeError, often only when the first message
    arrives.

    ## When it is quiet
    Where a variable may hold something else, or its type or attributes are asked for; where an AttributeError or
    TypeError is caught; for what an action client is handed, a message around the feedback or result (`.feedback`); for
    what rclpy hands to callbacks, whatever their annotations say (the goal handle of `execute_callback`, the future of
    `add_done_callback`, the bytes of `raw=True`); for packages outside of the workspace that a list of repositories
    fetches, and of others, unless the name is near a field or was one in ROS 1; for messages to whose class a module of
    the package adds attributes (`Point.norm = norm`); under a condition that is for ROS 1 (`ROS_VERSION == 1`); in
    files that nothing installs. A field that a comment or a page has people add is an info. A method of an object that
    is bound to a name which nothing reads is an info, unless its construction reaches it, as is one of a class that is
    defined again below. A use in a function whose callers catch what it raises, and in a test is a warning; one in an
    `except` branch, in what a `raise` or an assertion says, or of what an annotation alone calls a message, in a
    function that a thread or another file calls, is an info. A module that no entry point and no other file of the
    package names or imports, though others are started, is an info, and so is a function that no program leads to, what
    stands behind `rclpy.spin`, under the `__main__` of an entry point's module, under a switch that nothing throws, in
    a branch, under several conditions on the way from a program, and where no such way is shown. What a message is made
    with (`Twist(liner=…)`) raises up to Iron: where the pages, scripts and workflows of the repository name none after
    it, it is an error, where they name Jazzy or newer alone, an info, and else a warning.

    ## Fix safety
    The intended field is a guess.
    """
    for fields in together(uses.unknown()):
        weighed = worst_first(uses, [use for field in fields for use in field])
        (first, end), every = weighed[0], [use for use, _ in weighed]
        fix = None
        if first.near:
            edits = tuple(Edit(each.path, each.span, first.near) for each in every)
            fix = Fix(f"write `{first.near}`", edits, Safety.UNSAFE)
        related = tuple(Related(each.path, each.span, "and here") for each in every[1:])
        names = [field[0].name for field in fields]
        yield Hit(first.path, first.span, f"{message(first, names)}{end}", level_of(uses, every, end), related, fix)


def level_of(uses: FieldUses, places: Sequence[UnknownField], end: str) -> Severity | None:
    levels = {uses.level_of(each) for each in places}
    if end in NEVER or levels == {"info"}:
        return Severity.INFO
    return Severity.WARNING if end or None not in levels else None


def message(found: UnknownField, names: Sequence[str]) -> str:
    if found.is_by_place:
        return f"`{found.message}` takes its fields by name alone: this raises TypeError"
    start = f"`{found.message}` has no field{'s' if len(names) > 1 else ''} {in_ticks(names)}"
    end = f"; did you mean `{found.near}`?" if found.near else ""
    if found.is_keyword:
        return f"{start}: Humble raises AssertionError, and later distributions pass over it{end}"
    return f"{start}{' in ROS 2' if found.is_ros1 else ''}: this raises AttributeError{end}"
