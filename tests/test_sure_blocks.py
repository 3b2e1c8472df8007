"""Blocks of parameter files that no node is called after: surely lost, or for a node that may be somewhere."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NEEDS = "".join(f"  <depend>{each}</depend>\n" for each in ("rclcpp", "nav2_planner", "nav2_controller"))
BUILD = CMAKE.replace(
    "ament_package",
    "add_executable(rover src/rover.cpp)\nadd_executable(base src/base.cpp)\nadd_executable(spare src/spare.cpp)\n"
    "install(TARGETS rover base spare DESTINATION lib/${PROJECT_NAME})\n"
    "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package",
)
CODE = """\
#include <rclcpp/rclcpp.hpp>
class Receiver : public rclcpp::Node {
public:
  Receiver() : Node("NAME") {
    declare_parameter("level", 20);
    declare_parameter("is_kept", false);
  }
};
int main() {return 0;}
"""
LISTENER = """\
from rclpy.node import Node


class Listener(Node):
    def __init__(self):
        super().__init__('it')
"""
FILE = '<param from="$(find-pkg-share my_pkg)/config/logs.yaml"/>'


def node(package: str, program: str, more: str = "", *, tag: str = "node") -> str:
    return f'  <{tag} pkg="{package}" exec="{program}" {more}>{FILE}</{tag}>\n'


def own(program: str, name: str = "") -> str:
    return node("my_pkg", program, f'name="{name}"' if name else "")


def package(nodes: str, values: str) -> dict[str, str]:
    return {
        "package.xml": manifest(NEEDS, "ament_cmake"),
        "CMakeLists.txt": BUILD,
        **{f"src/{each}.cpp": CODE.replace("NAME", each) for each in ("rover", "base", "spare")},
        "launch/a.launch.xml": f"<launch>\n{nodes}</launch>\n",
        "config/logs.yaml": values,
    }


def found(nodes: str, *keys: str, **more: str) -> list[tuple[str, str]]:
    """Return key and level of the findings in a file with blocks of these names."""
    text = "".join(f"{key}:\n  ros__parameters:\n    level: 10\n    is_kept: true\n" for key in keys)
    files = package(nodes, text) | {f"my_pkg/{name}.py": code for name, code in more.items()}
    every = lint_files(files, ["PRM003"]).findings
    return [(keys[(each.location.line - 1) // 4], each.severity.value) for each in every]


@pytest.mark.parametrize("name", ["planner_server", "planner"])
def test_a_server_of_nav2_has_a_costmap_inside(name: str) -> None:
    costmap = "/global_costmap/global_costmap"
    assert found(node("nav2_planner", "planner_server", f'name="{name}"'), costmap) == []
    assert found(own("rover", "route"), costmap) == []


@pytest.mark.parametrize(
    "given",
    [
        node("controller_manager", "ros2_control_node", 'name="controller_manager"'),
        node("rclcpp_components", "component_container_mt", 'name="all" namespace=""', tag="node_container"),
        node("rclcpp_components", "component_container_isolated", 'name="all"'),
        node("moveit_ros_move_group", "move_group", 'name="move_group"'),
    ],
)
def test_a_process_that_loads_nodes_gives_them_its_files(given: str) -> None:
    assert found(given, "drive") == []


def test_a_program_of_another_package_may_make_more_nodes() -> None:
    assert found(node("gps_driver", "receiver", 'name="gps"'), "corrections") == [("corrections", "info")]
    assert found(node("gps_driver", "receiver", 'name="gps"'), "receiver") == [("receiver", "warning")]
    assert found(node("gps_driver", "receiver", 'name="gps"'), "gps_node") == [("gps_node", "warning")]
    slam = node("slam_toolbox", "async_slam_toolbox_node", 'name="mapper"')
    assert found(slam, "slam_toolbox") == [("slam_toolbox", "warning")]


def test_another_program_without_a_name_may_be_called_like_its_block() -> None:
    joy = node("joy", "joy_node", 'name="stick"')
    assert found(joy, "joy_node") == [("joy_node", "warning")]
    assert found(joy + node("joy", "joy_node"), "joy_node") == []
    assert found(joy + node("joy", "game_pad"), "joy_node") == [("joy_node", "info")]


def test_one_block_and_one_node_are_for_each_other() -> None:
    assert found(own("rover", "front"), "corrections") == [("corrections", "warning")]
    assert found(own("rover", "front") + own("base"), "base", "corrections") == [("corrections", "warning")]
    assert found(own("rover", "front"), "rover") == [("rover", "warning")]


def test_of_a_list_for_many_nodes_each_user_takes_a_part() -> None:
    nodes = own("rover", "front") + own("base")
    assert found(nodes, "base", "corrections", "network") == [("corrections", "info"), ("network", "info")]
    assert found(nodes, "base", "front_node", "network") == [("front_node", "warning"), ("network", "info")]


def test_a_node_that_only_code_or_a_comment_names_may_be_started() -> None:
    assert found(own("rover", "front"), "spare") == [("spare", "info")]
    assert found(own("rover", "front") + '  <!-- <node name="later"/> -->\n', "later") == [("later", "info")]
    assert found(own("rover", "front"), "it", listener=LISTENER) == [("it", "info")]


def test_numbered_names_are_of_several_nodes() -> None:
    assert found(own("rover", "camera1") + own("base"), "base", "camera2", "camera3") == [
        ("camera2", "info"),
        ("camera3", "info"),
    ]


@pytest.mark.parametrize(("beside", "level"), [("logs", "info"), ("other", "warning")])
def test_another_package_may_start_a_node_outside_of_the_namespace(beside: str, level: str) -> None:
    files = package(node("my_pkg", "rover", 'namespace="front"'), "rover:\n  ros__parameters:\n    level: 10\n")
    other = {
        "package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_cmake").replace(
            "e>my_pkg</n", "e>up</n"
        ),
        "CMakeLists.txt": CMAKE.replace("my_pkg", "up"),
        "launch/b.launch.xml": f"<launch>\n{own('rover').replace('logs', beside)}</launch>\n",
    }
    every = {f"my_pkg/{path}": text for path, text in files.items()} | {f"up/{path}": t for path, t in other.items()}
    assert [each.severity.value for each in lint_files(every, ["PRM003"]).findings] == [level]
