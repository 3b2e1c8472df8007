"""What a comment beside it says is still to be written is the task of whoever takes the exercise on: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.python.blank_names import is_blank, is_to_be_replaced
from rospkg_cli.checks.python.left_blank import announces
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("caller = my_pkg.caller:main")),
}
NODE = """\
import rclpy
from rclpy.node import Node


class Caller(Node):
    def __init__(self):
        super().__init__('caller')
        {start}
        self.create_timer(1.0, self.tick)

    def tick(self):
        {tick}
        self.get_logger().info('here')
        self.service_client.call_async(1)

    def other(self):
        # TODO: create the client
        print(1)


def main():
    rclpy.init()
    rclpy.spin(Caller())
"""


def told(start: str = "pass", tick: str = "pass") -> tuple[str, str]:
    (found,) = lint_files({**PYTHON, "my_pkg/caller.py": NODE.format(start=start, tick=tick)}, ["DEP117"]).findings
    return found.severity.value, found.message


TASKS = (
    "#### TO DO Create client ####",
    "# TODO: add a service here",
    "# YOUR CODE HERE",
    "# To-do: define a client",
)


@pytest.mark.parametrize("task", TASKS)
def test_where_it_would_be_set(task: str) -> None:
    for level, message in (told(start=task), told(tick=task)):
        assert (level, message.endswith("; a comment says that it is still to be written")) == ("info", True)


@pytest.mark.parametrize("task", ["# TODO: tune this", "# creates the client", "# TODO: add tests", "pass", "# done"])
def test_other_comments_say_nothing_of_it(task: str) -> None:
    assert told(start=task)[0] == told(tick=task)[0] == "warning"


def test_a_name_that_is_a_blank() -> None:
    text = NODE.format(start="print(___TODO___)", tick="pass").replace("self.service_client.call_async(1)", "pass")
    (found,) = lint_files({**PYTHON, "my_pkg/caller.py": text}, ["DEP117"]).findings
    assert (found.severity.value, found.message.endswith("a blank that is to be filled in")) == ("info", True)


BLOCK = """\
def far():
    # TODO: create the publisher
    pass

def near():
    {above}
    use(pub)
    # TODO: create the publisher
"""


@pytest.mark.parametrize(
    ("above", "is_told"),
    [
        ("# TODO", True),
        ("# TODO: implement", True),
        ("# ...", True),
        ("# TODO create the publisher\n    go()", True),
        ("if go:\n        # TODO create the publisher\n        pass", True),
        ("# TODO\n    go()", False),
        ("# TODO: add the timer\n    go()", False),
        ("# ...\n    go()", False),
        ("# a publisher", False),
        ("go()", False),
    ],
)
def test_the_block_around_a_place(above: str, is_told: bool) -> None:
    text = BLOCK.format(above=above)
    assert announces(text, text.index("use(pub)"), "pub") == is_told


def test_comments_behind_a_place_count_where_that_is_asked() -> None:
    text = BLOCK.format(above="go()")
    assert announces(text, text.index("use(pub)"), "pub", behind=True)
    assert not announces(text, text.index("use(pub)"), "timer", behind=True)


@pytest.mark.parametrize("name", ["___TODO___", "<your_name>", "YOUR_TOPIC", "FILL_ME_IN", "____", "{{ fill_in }}"])
def test_blanks(name: str) -> None:
    assert is_blank(name)


@pytest.mark.parametrize("name", ["_", "__", "todo_list", "your", "fill", "insert_here_now", "name", ""])
def test_no_blanks(name: str) -> None:
    assert not is_blank(name)


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("# <-- replace with your sim launch", True),
        ("# Change this to your map", True),
        ("# TODO: adapt path here", True),
        ("<!-- edit this -->", True),
        ("# the map of your lab", False),
        ("# replaced by the new one", False),
        ("# The only change is this line", False),
        ("# please change the name here", True),
        ("", False),
    ],
)
def test_a_comment_may_tell_to_write_another_name(said: str, expected: bool) -> None:
    text = f"first = 1  # replace this\nname = 'a.yaml'  {said}\n"
    assert is_to_be_replaced(text, text.index("a.yaml")) is expected


STARTED = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
    ),
}
LAUNCH = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    robot = os.path.join(share, 'urdf', '{}')  {}
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value=robot),
        Node(package='my_pkg', executable='{}', arguments=[robot]),  {}
    ])
"""


@pytest.mark.parametrize(
    ("name", "said", "level"),
    [
        ("arm.urdf", "", "warning"),
        ("arm.urdf", "# the robot", "warning"),
        ("arm.urdf", "# change this to your robot", "info"),
        ("your_robot.urdf", "", "info"),
        ("YOUR_ROBOT.urdf.xacro", "", "info"),
        ("your.urdf", "", "warning"),
    ],
)
def test_a_file_that_people_are_to_name_is_an_info(name: str, said: str, level: str) -> None:
    files = {**STARTED, "launch/a.launch.py": LAUNCH.format(name, said, "talker", "")}
    (found,) = lint_files(files, ["LCH003"]).findings
    assert found.severity.value == level
    assert ("until people name theirs there" in found.message) == (level == "info")


@pytest.mark.parametrize(("said", "level"), [("", "error"), ("# replace with your executable", "info")])
def test_a_program_that_people_are_to_name_is_an_info(said: str, level: str) -> None:
    files = {**STARTED, "launch/a.launch.py": LAUNCH.format("arm.urdf", "", "talker", said)}
    (found,) = lint_files(files, ["LCH002"]).findings
    assert found.severity.value == level
