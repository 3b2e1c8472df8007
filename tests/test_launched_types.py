"""Types of values that launch files give to nodes whose code is here, and names that variants of a file differ in."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

NODE = """\
#include "rclcpp/rclcpp.hpp"
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    declare_parameter("rate", 10.0);
    declare_parameter<int>("count", 1);
    declare_parameter("is_on", false);
    declare_parameter<std::string>("frame", "x");
    declare_parameter<std::vector<double>>("gains", {1.0});
  }
};
int main(int c, char ** v) { rclcpp::init(c, v); rclcpp::spin(std::make_shared<Talker>()); }
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker rclcpp::rclcpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY config launch urdf DESTINATION share/${PROJECT_NAME})
ament_package()
"""
PYTHON = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def words(text):
    found = text.strip()
    if not found:
        return []
    return ['taskset', '--cpu-list', found]


def setup(context):
    is_on = LaunchConfiguration('is_on').perform(context)
    return [Node(package='my_pkg', executable='talker', {})]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('is_on', default_value='true'),
        DeclareLaunchArgument('rate', default_value='10'),
        OpaqueFunction(function=setup),
    ])
"""
XML = '<launch><arg name="rate" default="10"/><node pkg="my_pkg" exec="talker">{}</node></launch>\n'
YAML = "launch:\n- node: {{pkg: my_pkg, exec: talker, param: [{{name: rate, value: {}}}]}}\n"
RATE = "LaunchConfiguration('rate')"


def said(files: dict[str, str], *codes: str) -> list[str]:
    package = {"package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"), "CMakeLists.txt": CMAKE}
    found = lint_files({**package, "src/talker.cpp": NODE, **files}, list(codes)).findings
    return [each.message for each in found]


@pytest.mark.parametrize(
    ("value", "part"),
    [
        ("'rate': 10", "an int stops the node"),
        ("'rate': -1", "an int stops the node"),
        ("'rate': '10.0'", "a string stops the node"),
        (f"'rate': {RATE}", "the default of `rate` is an int, which stops the node"),
        (f"'rate': {RATE}, 'rate': 1.0", ""),
        (f"'rate': ParameterValue({RATE}, value_type=float)", ""),
        (f"'rate': ParameterValue(value={RATE}, value_type=float)", ""),
        (f"'rate': float({RATE}.perform(context))", ""),
        ("'rate': '1e-3'", ""),
        ("'is_on': is_on", "`perform` returns a string, which stops the node"),
        ("'is_on': is_on == 'true'", ""),
        ("'is_on': 1", "an int stops the node"),
        ("'is_on': 'true'", "a string stops the node"),
        ("'frame': is_on", ""),
        ("'frame': LaunchConfiguration('is_on')", "the default of `is_on` is a bool"),
        (f"'frame': ['a', {RATE}]", ""),
        ("'frame': 5", "an int stops the node"),
        ("'count': 2.5", "a double stops the node"),
        ("'count': int('5')", ""),
        ("'gains': '1.0,2.0'", "a string stops the node"),
        ("'gains': [1.0, 2.0]", ""),
        ("'other': 5", ""),
    ],
)
def test_values_in_python(value: str, part: str) -> None:
    launch = PYTHON.replace("{}", f"parameters=[{{{value}}}]")
    found = said({"launch/a.launch.py": launch}, "PRM006")
    assert [part in each for each in found] == [True] * bool(part)


@pytest.mark.parametrize(
    ("param", "count"),
    [
        ('<param name="rate" value="10"/>', 1),
        ('<param name="rate" value="10."/>', 0),
        ('<param name="rate" value="10" type="float"/>', 0),
        ('<param name="rate" value="$(var rate)"/>', 1),
        ('<param name="rate" value="$(var rate)" type="float"/>', 0),
        ('<param name="is_on" value="1"/>', 1),
        ('<param name="rate" value="10"/><param name="rate" value="10.0"/>', 0),
        ("""<param name="frame" value="'5'"/>""", 0),
    ],
)
def test_values_in_xml(param: str, count: int) -> None:
    assert len(said({"launch/a.launch.xml": XML.format(param)}, "PRM006")) == count


@pytest.mark.parametrize(
    ("condition", "count"),
    [("$(eval '$(var rate) != 10')", 0), ("$(var rate)", 0), ("$(eval '2 > 1')", 1), ("False", 1), ("$(var on)", 1)],
)
def test_a_default_that_a_condition_excludes_reaches_no_node(condition: str, count: int) -> None:
    launch = XML.replace('exec="talker"', f'exec="talker" if="{condition}"')
    launch = launch.format('<param name="rate" value="$(var rate)"/>')
    assert len(said({"launch/a.launch.xml": launch}, "PRM006")) == count


@pytest.mark.parametrize(("value", "count"), [("10", 1), ("10.0", 0), ('"10"', 0)])
def test_values_in_yaml(value: str, count: int) -> None:
    assert len(said({"launch/a.launch.yaml": YAML.format(value)}, "PRM006")) == count


@pytest.mark.parametrize(
    ("given", "part"),
    [
        ("parameters=[LaunchConfiguration('speed', default=10.0)]", "`speed` stands among parameters"),
        ("parameters=[LaunchConfiguration('speed', default='a/b.yaml')]", ""),
        ("parameters=[LaunchConfiguration('speed_file', default='x')]", ""),
        ("prefix=['xterm', '-e']", "`xterm` and the next become one word"),
        ("prefix=['xterm ', '-e']", ""),
        ("prefix=['xterm -e']", ""),
        ("prefix=words(is_on)", "`taskset` and the next become one word"),
        ("arguments=[['--id', 'y']]", "`--id` is joined with what follows"),
        ("arguments=[['--id=', 'y']]", ""),
        ("arguments=['--id', ['a', 'b']]", ""),
    ],
)
def test_lists_of_launch_ros(given: str, part: str) -> None:
    found = said({"launch/a.launch.py": PYTHON.replace("{}", given)}, "LCH014")
    assert [part in each for each in found] == [True] * bool(part)


@pytest.mark.parametrize(("more", "count"), [("", 1), ("    count: 2\n", 0)])
def test_a_name_that_the_variant_for_another_robot_has_otherwise(more: str, count: int) -> None:
    start = "/**:\n  ros__parameters:\n    frame: map\n"
    files = {"config/boat/a.yaml": f"{start}    speed: 1.0\n{more}", "config/car/a.yaml": f"{start}    rate: 2.0\n"}
    launch = XML.format('<param from="$(find-pkg-share my_pkg)/config/$(env ROBOT)/a.yaml"/>')
    assert len(said({**files, "launch/a.launch.xml": launch}, "PRM007")) == count


@pytest.mark.parametrize(
    ("mesh", "count"),
    [("a.stl", 1), ("../meshes/a.STL", 0), ("package://my_pkg/urdf/a.stl", 0), ("file:///a.stl", 0), ("b.stl", 0)],
)
def test_meshes_without_a_scheme(mesh: str, count: int) -> None:
    robot = f'<robot name="r"><link name="a"><visual><geometry><mesh filename="{mesh}"/></geometry></visual></link>'
    launch = '<launch><let name="m" value="$(find-pkg-share my_pkg)/urdf/r.urdf"/></launch>\n'
    files = {"urdf/r.urdf": f"{robot}</robot>\n", "urdf/a.stl": "solid a\n", "launch/a.launch.xml": launch}
    assert len(said(files, "URD002")) == count


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ("'load_controller', '--set-state', 'start', 'arm'", 1),
        ("'load_controller', 'arm', '--set-state', 'configure'", 1),
        ("'load_controller', '--set-state', 'active', 'arm'", 0),
        ("'load_controller', 'start'", 0),
        ("'load_start_controller', 'arm'", 1),
    ],
)
def test_words_of_ros2_control(words: str, count: int) -> None:
    launch = PYTHON.replace("OpaqueFunction\n", "ExecuteProcess\n").replace(
        "        OpaqueFunction(function=setup),\n", ""
    )
    launch = launch.replace(
        "return LaunchDescription([\n",
        f"run = ExecuteProcess(cmd=['ros2', 'control', {words}])\n    return LaunchDescription([run,\n",
    )
    assert len(said({"launch/a.launch.py": launch.replace("{}", "")}, "LCH005")) == count


def test_a_former_name_in_a_parameter_file() -> None:
    values = "/**:\n  ros__parameters:\n    camera_info_url: package://{}/config/camera.yaml\n"
    files = {"config/camera.yaml": "image_width: 5\n", "config/a.yaml": values.format("former_name_of_my_pkg")}
    assert "did you mean `my_pkg`" in said(files, "DEP106")[0]
    assert not said({**files, "config/a.yaml": values.format("my_pkg")}, "DEP106")


@pytest.mark.parametrize(
    ("attributes", "count"),
    [
        ('value="1.0, 2.0"', 1),
        ('value="1.0, 2.0" value-sep=","', 0),
        ('value="1.0" type="list_of_float"', 0),
    ],
)
def test_a_list_may_be_written_as_one_text_with_its_separator_or_type(attributes: str, count: int) -> None:
    launch = XML.format(f'<param name="gains" {attributes}/>')
    assert len(said({"launch/a.launch.xml": launch}, "PRM006")) == count


LAUNCHED = "<launch>\n  <node pkg='my_pkg' exec='talker'>\n    <param {}/>\n  </node>\n</launch>\n"


@pytest.mark.parametrize("given", ["name='rate' value='1'", "from='$(find-pkg-share my_pkg)/config/a.yaml'"])
@pytest.mark.parametrize(
    ("page", "level"),
    [("", "warning"), ("For ROS 2 Foxy.\n", "info"), ("For ROS 2 Foxy and ROS 2 Humble.\n", "warning")],
)
def test_foxy_takes_any_type(given: str, page: str, level: str) -> None:
    """Where another page than those that are read first names it alone."""
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE,
        "src/talker.cpp": NODE,
        "config/a.yaml": "talker:\n  ros__parameters:\n    rate: 10\n" if "a.yaml" in given else "{}\n",
        "launch/a.launch.xml": LAUNCHED.format(given),
        "docs/SETUP.md": page,
    }
    (found,) = lint_files(files, ["PRM006"]).findings
    assert (found.severity.value, ", but not in Foxy" in found.message) == (level, level == "info")
