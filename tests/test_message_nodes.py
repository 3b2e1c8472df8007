"""Nodes that publish a message of one's own or listen to it."""

from __future__ import annotations

import itertools
import signal
from pathlib import Path

import pytest
from planned import around, plan, texts
from test_generated_nodes import STOPS, Running

from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.message import Message

STATUS = (
    "RobotStatus:std_msgs/Header header, builtin_interfaces/Time since, float32 battery_level, string<=9 current_task, "
    "uint8 OK=0, uint8 error_status, bool[] doors, int32 count 7, Other other",
    "Other:",
)
THERE = around(plan("my_robot_nav_interfaces", template="interfaces", msgs=STATUS, srvs=("Go",)))
NODES = ("status:publisher", "monitor:subscriber")


@pytest.mark.parametrize("distro", [each.name for each in DISTROS])
@pytest.mark.parametrize("template", ["ament_python", "ament_cmake", "mixed"])
def test_they_are_written_without_a_finding(template: str, distro: str) -> None:
    languages = {"ament_python": ("python",), "ament_cmake": ("cpp",), "mixed": ("cpp", "python")}[template]
    nodes = tuple(
        f"{language}_{node}:{language}:{message}"
        for node, language, message in itertools.product(NODES, languages, ("RobotStatus", "geometry_msgs/msg/Twist"))
        if message == "RobotStatus" or node == NODES[0]
    )
    nodes = tuple(node.replace(":", f"_{number}:", 1) for number, node in enumerate(nodes))
    assert plan(there=THERE, template=template, nodes=nodes, distro=distro).findings == ()


def test_fields_with_a_plain_value_are_set() -> None:
    """An array, a default, and a message of one's own keep what they have."""
    source = texts(plan(there=THERE, nodes=("status:publisher:RobotStatus",)))["my_robot_nav/status.py"]
    assert [line.strip() for line in source.splitlines() if line.strip().startswith("message.")] == [
        "message.header.stamp = self.get_clock().now().to_msg()",
        "message.since = self.get_clock().now().to_msg()",
        "message.battery_level = 0.0",
        "message.current_task = ''",
        "message.error_status = 0",
    ]


def test_the_package_of_the_message_is_declared_found_and_linked() -> None:
    files = texts(plan(there=THERE, template="ament_cmake", nodes=("status:RobotStatus",)))
    assert "<depend>my_robot_nav_interfaces</depend>" in files["package.xml"]
    assert "find_package(my_robot_nav_interfaces REQUIRED)\n" in files["CMakeLists.txt"]
    assert "  ${my_robot_nav_interfaces_TARGETS}\n" in files["CMakeLists.txt"]
    assert '#include "my_robot_nav_interfaces/msg/robot_status.hpp"\n' in files["src/status.cpp"]


@pytest.mark.parametrize(
    "name, header", [("RobotStatus", "robot_status"), ("UUID", "uuid"), ("ABCPart", "abc_part"), ("Pose2D", "pose2_d")]
)
def test_the_header_has_the_name_that_rosidl_gives_it(name: str, header: str) -> None:
    assert Message("a_pkg", name).topic == header


REFUSED = {
    "a_node:timer:RobotStatus": "that of publisher, subscriber, service, client, action-server or action-client",
    "a_node:std_msgs/Strng": r"`std_msgs` has no message `Strng` \(did you mean `String`\?\)",
    "a_node:nav_msgs/GoalPoze": "no message `GoalPoze`",
    "a_node:Twist": "Write `geometry_msgs/Twist`",
    "a_node:Waypoint": "rospkg new my_robot_nav_interfaces --type interfaces --msg Waypoint",
    "a_node:my_robot_nav_interfaces/RobotState": "did you mean `RobotStatus`",
    "a_node:my_robot_nav_interfaces/Gone": "no message `Gone`",
    "a_node:a_pkg/b/C": "PACKAGE/Name",
    "a_node:Robot_Status": "PACKAGE/Name",
    "a_node:some_msgs/Node": "another name",
    "a_node:some_messages_of_an_old_friend_of_mine/" + "A" * 38: "too long",
    "a_node:some_msgs/" + "Ab" * 14: "too long",
    "a_node:std_msgs/String:std_msgs/Bool": "has too many parts",
    "a_node:std_msgs/String@a:@b": "has too many parts",
    "a_node:timer@tick": "leave `@tick` out",
    "a_node:publisher@a__b": "write it as @/scan or @scan",
    "a_node@a_name_of_a_topic_that_is_long": "too long",
    "a_node:publisher:sensor_data": "publisher:std_msgs/String:sensor_data",
    "a_node:service:std_srvs/SetBool:sensor_data": "is for the topic of a message",
    "a_node:publisher:std_msgs/String:sensor_dat": "did you mean `sensor_data`",
    "a_node:publisher:my_robot_nav_interfaces/Go": "is no message but a service",
    "a_node:client:std_srvs/SetBol": "did you mean `SetBool`",
    "a_node:action-client:Fly": "no package here has an action `Fly`.* --action Fly",
    "a_node:service:std_msgs/msg/String": "`std_msgs/msg/String` is no service but a message",
    "a_node:sensor_msgs/srv/SetCameraInfo": "is no message but a service",
    "a_node:publisher:nav_msgs/odometry": "can't be a message: PACKAGE/Name; did you mean `nav_msgs/Odometry`",
    "a_node:publisher:nav_msgs/occupancy_grid": "did you mean `nav_msgs/OccupancyGrid`",
    "a_node:publisher:my_robot_nav_interfaces/robotstatus": "did you mean `my_robot_nav_interfaces/RobotStatus`",
    "a_node:publisher:nobody_msgs/odometry": "can't be a message: PACKAGE/Name, as std_msgs/String",
}


@pytest.mark.parametrize("node", REFUSED)
def test_what_cannot_be_is_refused(node: str) -> None:
    with pytest.raises(ScaffoldError, match=REFUSED[node]):
        plan(there=THERE, nodes=(node,))


@pytest.mark.parametrize("name", ["A" * 40, "Ab" * 13, "Abcdefghijklmnopqrs" * 2])
def test_names_that_are_taken_fit_their_lines(name: str) -> None:
    package = "a_robot_interfaces_pkg_of_mine"
    nodes = [
        f"{kind}_{n}:{kind}er:{language}:{package}/{name}"
        for n, language in enumerate(("cpp", "python"))
        for kind in ("publish", "subscrib")
    ]
    planned = plan(template="mixed", nodes=tuple(nodes))
    for path, text in texts(planned).items():
        if path.endswith((".py", ".cpp")):
            long = [line for line in text.splitlines() if len(line) > 99 and not line.startswith("#include")]
            assert long == [], path


def test_whose_message_it_is_must_be_clear() -> None:
    there = around(*(plan(name, template="interfaces", msgs=("Foo:",)) for name in ("one_msgs", "two_msgs")))
    with pytest.raises(ScaffoldError, match="Write `one_msgs/Foo` or `two_msgs/Foo`"):
        plan(there=there, nodes=("a_node:Foo",))


def test_what_a_package_was_before_is_not_around_it() -> None:
    there = around(plan("my_robot_nav", template="interfaces", msgs=("Foo:",)))
    with pytest.raises(ScaffoldError, match="no package here has a message `Foo`"):
        plan(there=there, nodes=("a_node:Foo",))


MODULE = """\
class RobotStatus:
    def __init__(self, data=''):
        self.battery_level, self.current_task, self.said = 1.0, 'none', data

    def __str__(self):
        return f'RobotStatus({self.said})'
"""
SMALL = around(
    plan("small_msgs", template="interfaces", msgs=("RobotStatus:float32 battery_level, string current_task",))
)


@pytest.mark.parametrize("number", STOPS)
def test_the_publisher_publishes_it(tmp_path: Path, number: signal.Signals) -> None:
    planned = plan(there=SMALL, nodes=("status:publisher:RobotStatus",))
    node = Running(planned, tmp_path, {"rate": 50.0}, modules={"small_msgs/msg.py": MODULE})
    published = node.until("publish", 2)[0]
    assert published["topic"] == "robot_status"
    assert (published["data"]["battery_level"], published["data"]["current_task"]) == (0.0, "")
    node.stop(number)


def test_the_subscriber_logs_it(tmp_path: Path) -> None:
    planned = plan(there=SMALL, nodes=("monitor:subscriber:RobotStatus",))
    node = Running(planned, tmp_path, modules={"small_msgs/msg.py": MODULE})
    assert node.heard(3) == "[INFO] ready\n" + "[INFO] RobotStatus(Hello)\n" * 2
