"""Calls of rclpy, of nodes, of look-ups and of messages with what they do not take: they raise TypeError."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

DEPENDS = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in ("rclpy", "sensor_msgs", "ament_index_python"))
PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest(DEPENDS),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "spare = my_pkg.spare:main")),
    "my_pkg/spare.py": "def main():\n    pass\n",
}
NODE = """\
import sys
import rclpy
from ament_index_python.packages import get_package_prefix, get_package_share_directory
from rclpy.node import Node
from sensor_msgs.msg import Image, PointField
import sensor_msgs_py.point_cloud2 as pc2


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {start}
        self.create_subscription(Image, 'images', self.hear, 10)

    def hear(self, msg):
        {hear}


def main():
    {main}
    rclpy.init()
    rclpy.spin(Talker())
"""


def found(codes: str, files: dict[str, str] | None = None, **parts: str) -> list[tuple[str, str, str]]:
    """Return the code, the level and the reported text of each finding."""
    text = NODE.format(**{"start": "pass", "hear": "print(msg)", "main": "pass", **parts})
    findings = lint_files({**PYTHON, "my_pkg/talker.py": text, **(files or {})}, codes.split()).findings
    return [
        (each.code, each.severity.value, text[each.location.span.start : each.location.span.end]) for each in findings
    ]


@pytest.mark.parametrize(
    "call, name",
    [
        ("rclpy.init(sys.argv)", "init"),
        ("rclpy.shutdown(None)", "shutdown"),
        ("rclpy.spin()", "spin"),
        ("rclpy.spin_once(object(), 0.1)", "spin_once"),
        ("rclpy.create_node()", "create_node"),
        ("rclpy.create_node('a', 'b')", "create_node"),
        ("rclpy.spin_until_future_complete(object())", "spin_until_future_complete"),
    ],
)
def test_functions_of_rclpy(call: str, name: str) -> None:
    assert found("DEP120", main=call) == [("DEP120", "error", name)]


@pytest.mark.parametrize(
    "call",
    [
        "rclpy.init(args=sys.argv)",
        "rclpy.init(*sys.argv)",
        "rclpy.spin(node=object())",
        "rclpy.create_node(**{})",
        "rclpy.spin(object(), None)",
        "init(1)",
        "try:\n        rclpy.init(1)\n    except TypeError:\n        pass",
    ],
)
def test_calls_that_may_be_right(call: str) -> None:
    assert found("DEP120", main=call) == []


@pytest.mark.parametrize(
    "call, name",
    [
        ("self.create_publisher(Image, 'images')", "create_publisher"),
        ("self.create_subscription(Image, 'images', self.hear)", "create_subscription"),
        ("self.create_timer(1.0)", "create_timer"),
        ("self.create_client(Image)", "create_client"),
    ],
)
def test_methods_of_nodes(call: str, name: str) -> None:
    assert found("DEP120", start=call) == [("DEP120", "error", name)]
    assert found("DEP120", hear=call) == [("DEP120", "warning", name)]
    assert found("DEP120", hear=f"if msg:\n            {call}") == [("DEP120", "info", name)]


@pytest.mark.parametrize(
    "call",
    [
        "self.create_publisher(Image, 'images', qos_profile=10)",
        "self.create_publisher(Image, *self.rest)",
        "self.create_timer(1.0, self.hear, None, None, True)",
        "self.other.create_timer(1.0)",
    ],
)
def test_methods_that_may_be_called_so(call: str) -> None:
    assert found("DEP120", start=call) == []


def test_a_method_that_a_class_of_the_package_defines() -> None:
    own = {"my_pkg/spare.py": "class Spare:\n    def create_timer(self, period):\n        pass\n"}
    assert found("DEP120", own, start="self.create_timer(1.0)") == []


def test_fields_of_messages_have_names() -> None:
    assert found("IDL010", start="PointField('x', 0)") == [("IDL010", "error", "'x'")]
    assert found("IDL010", start="pc2.PointField('x', 0)") == [("IDL010", "error", "'x'")]
    assert found("IDL010", hear="if msg:\n            PointField('x', 0)") == [("IDL010", "info", "'x'")]


@pytest.mark.parametrize(
    "call",
    [
        "PointField(*[])",
        "pc2.read_points(0)",
        "try:\n            PointField(1)\n        except TypeError:\n            0",
    ],
)
def test_messages_that_may_be_made(call: str) -> None:
    assert found("IDL010", start=call) == []


def test_what_stands_behind_such_a_message() -> None:
    behind = "if msg:\n            a = PointField('x')\n            late(a)"
    assert found("IDL010 DEP117", hear=behind) == [("IDL010", "info", "'x'"), ("DEP117", "info", "late")]
    before = "if msg:\n            late()\n            PointField('x')"
    assert found("IDL010 DEP117", hear=before) == [("DEP117", "warning", "late"), ("IDL010", "info", "'x'")]


def test_look_ups_with_more_than_they_take() -> None:
    call = "get_package_share_directory('nav2_bringup', 'maps', 'a.yaml')"
    name = "get_package_share_directory"
    assert found("DEP112 DEP113 DEP116", main=call) == [("DEP112", "error", name)]
    assert found("DEP112", main="get_package_prefix('my_pkg', 'lib')") == [("DEP112", "error", "get_package_prefix")]
    assert found("DEP112", main="get_package_share_directory()") == [("DEP112", "error", name)]
    assert found("DEP112", hear=f"if msg:\n            {call}") == [("DEP112", "warning", name)]
    assert found("DEP112", main="get_package_share_directory('my_pkg', False)") == []
    assert found("DEP112", main="get_package_share_directory(*sys.argv)") == []


def test_an_undeclared_package_of_a_program_that_nothing_starts() -> None:
    page = {"README.md": "    ros2 run my_pkg spare\n"}
    call = "get_package_share_directory('nav2_bringup')"
    assert found("DEP116", main=call) == [("DEP116", "warning", "'nav2_bringup'")]
    assert found("DEP116", page, main=call) == [("DEP116", "info", "'nav2_bringup'")]


@pytest.mark.parametrize(
    ("page", "level"),
    [
        ("Needs `sudo apt install ros-crystal-desktop`.\n", "info"),
        ("export ROS_DISTRO=crystal\n", "info"),
        ("source /opt/ros/dashing/setup.bash\n", "info"),
        ("For Dashing and Foxy.\n", "error"),
        ("A crystal clear page.\n", "error"),
    ],
)
def test_a_depth_that_the_distributions_of_the_pages_do_not_ask_for(page: str, level: str) -> None:
    start = "self.create_publisher(Image, 'a')"
    assert found("DEP120", {"README.md": page}, start=start) == [("DEP120", level, "create_publisher")]
    assert found("DEP120", {"Dockerfile": "FROM ros:crystal\n"}, start=start)[0][1] == "info"
    assert found("DEP120", {"README.md": page}, start="self.create_timer(1.0)")[0][1] == "error"


def test_what_follows_a_call_that_older_distributions_take() -> None:
    start = "self.create_publisher(Image, 'a'); self.create_timer(1.0)"
    told = found("DEP120", {"Dockerfile": "FROM ros:dashing\n"}, start=start)
    assert [level for _, level, _ in told] == ["info", "error"]
