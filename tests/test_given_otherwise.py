"""Parameters without a default that a node gets otherwise than by its launch action, or that not every run declares."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

BUILD = CMAKE.replace(
    "ament_package",
    "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
    "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package",
)
CODE = """\
class Talker : public rclcpp::Node
{{
public:
  Talker() : Node("talker"{})
  {{
    {}
  }}
  void add()
  {{
    {}
  }}
}};
int main() {{return 0;}}
"""
NEEDED = 'declare_parameter<double>("rate");'
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, SetParameter, SetParametersFromFile


def generate_launch_description():
    config = 'a.yaml'
    return LaunchDescription([{}])
"""
NODE = "Node(package='my_pkg', executable='talker', name='talker'{})"
SERVER = """\
planner_server:
  ros__parameters:
    planner_plugins: [{}]
    {}: {{plugin: nav2_navfn_planner::NavfnPlanner}}
"""


def found(launch: str = LAUNCH.format(NODE.format("")), code: str = "", values: str = "") -> list[str]:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": BUILD,
        "src/talker.cpp": code or CODE.format("", NEEDED, ""),
        "launch/a.launch.py": launch,
        "config/nav.yaml": values or "/**:\n  ros__parameters:\n    a: 1\n",
    }
    return [f"{each.severity.value}: {each.message}" for each in lint_files(files, ["PRM008"]).findings]


@pytest.mark.parametrize(
    ("more", "beside", "count"),
    [
        ("", "", 1),
        (", arguments=['--ros-args', '-p', 'rate:=1.0']", "", 0),
        (", arguments=['--ros-args', '--params-file', config]", "", 0),
        (", ros_arguments=['-p', 'rate:=1.0']", "", 0),
        (", arguments=['loud']", "", 1),
        ("", "SetParameter('rate', 1.0), ", 0),
        ("", "SetParameter(name='rate', value=1.0), ", 0),
        ("", "SetParameter(name='use_sim_time', value=True), ", 1),
        ("", "SetParameter(name=config, value=True), ", 0),
        ("", "SetParametersFromFile(config), ", 0),
    ],
)
def test_a_node_gets_parameters_by_other_ways(more: str, beside: str, count: int) -> None:
    assert len(found(LAUNCH.format(beside + NODE.format(more)))) == count


def test_elements_of_xml_set_parameters_for_all_nodes() -> None:
    node = '<node pkg="my_pkg" exec="talker" name="talker"/>'
    for name, count in (("rate", 0), ("use_sim_time", 1)):
        files = {
            "package.xml": manifest("", "ament_cmake"),
            "CMakeLists.txt": BUILD,
            "src/talker.cpp": CODE.format("", NEEDED, ""),
            "launch/a.launch.xml": f'<launch><set_parameter name="{name}" value="1.0"/>{node}</launch>\n',
        }
        assert len(lint_files(files, ["PRM008"]).findings) == count


@pytest.mark.parametrize(
    ("options", "inside", "function", "count"),
    [
        ("", "add();", NEEDED, 1),
        ("", "this->add();", NEEDED, 1),
        ("", "if (is_on_) add();", NEEDED, 0),
        ("", "if (is_on_) { add(); }", NEEDED, 0),
        ("", "timer_ = create_wall_timer(1s, [this]() { add(); });", NEEDED, 0),
        ("", "timer_ = create_wall_timer(1s, std::bind(&Talker::add, this));", NEEDED, 0),
        ("", "", NEEDED, 0),
        ("", f"try {{ {NEEDED} }} catch (const std::exception & error) {{}}", "", 0),
        (', rclcpp::NodeOptions().append_parameter_override("rate", 1.0)', NEEDED, "", 0),
        (", rclcpp::NodeOptions()", NEEDED, "", 1),
    ],
)
def test_not_every_run_declares_it(options: str, inside: str, function: str, count: int) -> None:
    assert len(found(code=CODE.format(options, inside, function))) == count


@pytest.mark.parametrize(
    ("listed", "group", "expected"),
    [
        ("GridBased", "Theta", []),
        ("GridBased", "GridBase", ["info: `GridBased` has no `GridBased.plugin` here: its default is loaded"]),
        ("Grid", "Theta", ["info: `Grid` has no `Grid.plugin` here: the plugin can't be loaded"]),
    ],
)
def test_a_default_list_of_plugins_has_types(listed: str, group: str, expected: list[str]) -> None:
    some = found(LAUNCH.format(NODE.format(", parameters=[{'rate': 1.0}]")), values=SERVER.format(listed, group))
    assert [each.partition(";")[0] for each in some] == expected


@pytest.mark.parametrize(("more", "count"), [("", 1), (", {'Other.plugin': 'my_pkg::Other'}", 0)])
def test_a_launch_file_may_give_a_plugin_its_type(more: str, count: int) -> None:
    launch = LAUNCH.format(NODE.format(f", parameters=[{{'rate': 1.0}}{more}]"))
    assert len(found(launch, values=SERVER.format("Grid, Other", "Grid"))) == count
