"""DEP120 unknown-rclpy-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.wrong_rclpy_calls import FOR_OLDER, WrongRclpyCalls
from ...example import Example, manifest, scripts, setup_py
from ...finding import Hit, Severity
from ...ros.rclpy_names import OF_ROSPY
from ...rule import rule

FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.get_logger().info('here')


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@rule(
    "DEP120",
    "unknown-rclpy-name",
    over=WrongRclpyCalls,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function that a program is shown to come to, under one condition at most, in a "
        "test, in a module of a library that nothing here imports, or in a program that nothing starts, while others "
        "that are started",
        Severity.INFO: "no program is shown to reach it, or under several conditions alone, it is under a condition "
        "(`__main__` of an entry point's module, a switch that is off), behind `rclpy.spin`, nothing in the package "
        "calls the function, or imports the module, nothing spins the node, the run ends before, at another fault or "
        "in a loop, its own text, or a page, says that the program is not to be started, nothing starts it while "
        "others use its module, or the repository is for Dashing or older alone, which need no depth",
    },
    examples=(
        Example(
            bad={**FILES, "my_pkg/talker.py": NODE.replace("rclpy.spin", "rclpy.«spinn»")},
            good={"my_pkg/talker.py": NODE},
        ),
        Example(
            bad={**FILES, "my_pkg/talker.py": NODE.replace("create_timer", "«creat_timer»")},
            good={"my_pkg/talker.py": NODE},
        ),
    ),
)
def unknown_rclpy_name(calls: WrongRclpyCalls) -> Iterator[Hit]:
    """
    ## What it does
    Finds names that code takes from rclpy or from its own node, and that these do not have.
    It reports a name that is a letter or two from one that exists (`rclpy.spinn`, `self.create_publishr`), those of
    rospy (`rclpy.Rate`, `rclpy.loginfo`), and those taken from `self.get_logger` and `self.get_clock` without the call.
    Calls with what no distribution takes are reported, too: `rclpy.init(sys.argv)`, which takes its `args` by name
    alone, and `self.create_publisher(String, 'words')` without a depth. So are calls that an own class refuses, where
    it and all of its bases are known, in the constructor, of `self`, or of an object that a name or a member is given
    once: `robot = Robot()`, and then `robot.stop(1)`, whose method takes `self` alone.

    ## Why is this bad?
    Nothing looks before the line runs: the build is green, and the node ends with AttributeError or TypeError.

    ## When it is quiet
    For any other name, as a newer rclpy may have it; for classes that have other bases than rclpy's nodes, for methods
    that any class of the package has, in files that bind `rclpy` themselves or set names by `setattr`, for calls with
    `*` or `**` that may be right or whose TypeError is caught, and under what never holds on Linux. So is the type of a
    variable or member in a function, which Python does not evaluate, and every type where a file imports `annotations`
    of `__future__`. A depth that is missing is an info where the repository names Dashing or older ones alone. So is
    what only the `main` of a module reaches that nothing starts, while the programs that are started import the module,
    a base class for example, or of which a docstring or comment says `DO NOT RUN`.

    ## References
    The names of all branches of ros2/rclpy from Foxy on.
    """
    for each in calls.names.all():
        what = WHAT.get(each.owner, f"`{each.owner}` is a method, and has no")
        is_of_rospy = each.name in OF_ROSPY and each.owner in WHAT
        advice = f"rospy has it; write `{each.better}`" if is_of_rospy else f"did you mean `{each.better}`?"
        message = f"{what} `{each.name}`: {ENDS[each.when]} with AttributeError; {advice}"
        yield Hit(each.file.path, each.span, message, LEVELS[each.when])
    for wrong in calls.all():
        called = wrong.called
        what = f"{called.owner}.{called.name}" if called.owner else called.name
        message = f"`{what}` {wrong.why}: {ENDS[called.when]} with TypeError"
        message += FOR_OLDER if wrong.is_for_older else ""
        yield Hit(called.file.path, called.span, message, Severity.INFO if wrong.is_for_older else LEVELS[called.when])


WHAT = {"rclpy": "`rclpy` has no", "self": "a node has no"}
LEVELS = {
    "certainly": None,
    "maybe": Severity.WARNING,
    **dict.fromkeys(("branch", "late", "ended", "unspun", "seldom", "unshown", "never"), Severity.INFO),
}
ENDS = {
    "certainly": "the start ends here",
    "maybe": "the line ends",
    "branch": "the line ends, under its condition,",
    "late": "the line ends, where `spin` returns,",
    "ended": "the line ends, once the loop has ended in which the program stays,",
    "unspun": "the line ends, in a callback of a node that nothing spins,",
    "seldom": "the line ends, where several conditions hold at once,",
    "unshown": "the line ends, once a program reaches it,",
    "never": "the line ends, once something calls it,",
}
