"""YAML that only code opens, a launch file for single values or a node by its own parser, is no parameter file."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = """\
#include <rclcpp/rclcpp.hpp>
class Fixer : public rclcpp::Node
{
public:
  Fixer() : Node("fixer")
  {
    declare_parameter<std::string>("topic_name", "a");
    declare_parameter<double>("min_value", -1.0);
    declare_parameter<double>("max_value", 1.0);
  }
};
"""
LAUNCH = """\
import os

import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch_ros.actions import Node


def load(package, path):
    with open(os.path.join(get_package_share_directory(package), path)) as f:
        return yaml.safe_load(f)


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_pkg'), 'config', 'fix.yaml')
    with open(path) as f:
        config = yaml.safe_load(f)['/**']['ros__parameters']
    nodes = [
        Node(package='my_pkg', executable='fixer', name=f'fixer_{i}', parameters=[{
            'topic_name': topic, 'min_value': float(config['min_value'][i])}])
        for i, topic in enumerate(config['topic_name'])
    ]
    return LaunchDescription(nodes)
"""
CONFIG = """\
/**:
  ros__parameters:
    topic_name: [a, b]
    min_value: [-0.5, -10]
fixer_:
  ros__parameters:
    topic_name: 5
    min_vale: 1
    max_value: 1e3
  rest: 3
other:
  topic_name: x
"""
PACKAGE = {
    "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
    "src/fixer.cpp": NODE,
    "config/fix.yaml": CONFIG,
}
RULES = [f"PRM{number:03}" for number in range(1, 11)]


def codes(launch: str, **more: str) -> set[str]:
    files = {**PACKAGE, "launch/fix.launch.py": launch, **more}
    return {each.code for each in lint_files(files, RULES).findings if each.location.path == "config/fix.yaml"}


def test_no_rule_speaks_of_yaml_that_only_a_launch_file_opens() -> None:
    assert codes(LAUNCH) == set()


FIRST = "Node(package='my_pkg', executable='fixer', parameters=[{}]),\n        *["


@pytest.mark.parametrize(
    "entry",
    [
        "path",
        "config",
        "load('my_pkg', 'config/fix.yaml')['/**']['ros__parameters']",
        "{**config, 'x': 1}",
        "dict(config)",
    ],
)
def test_yaml_that_a_node_gets_as_a_whole_is_told(entry: str) -> None:
    launch = LAUNCH.replace(
        "nodes = [", f"nodes = [Node(package='my_pkg', executable='fixer', parameters=[{entry}])] + ["
    )
    assert {"PRM006", "PRM007"} <= codes(launch)


@pytest.mark.parametrize(
    "action",
    [
        "IncludeLaunchDescription('x.launch.py', launch_arguments={'params_file': path}.items())",
        "DeclareLaunchArgument('params_file', default_value=path)",
        "Node(package='x', executable='y', arguments=['--params-file', path])",
    ],
)
def test_yaml_whose_path_is_given_on_is_told(action: str) -> None:
    launch = LAUNCH.replace("return LaunchDescription(nodes)", f"return LaunchDescription([{action}, *nodes])")
    assert {"PRM006", "PRM007"} <= codes(launch)


def test_yaml_that_a_script_gives_to_a_node_is_told() -> None:
    run = "ros2 run my_pkg fixer --ros-args --params-file install/my_pkg/share/my_pkg/config/fix.yaml\n"
    assert {"PRM006", "PRM007"} <= codes(LAUNCH, **{"scripts/run.sh": run})
    assert codes(LAUNCH, **{"scripts/run.sh": run.replace("--params-file", "-f")}) == set()


def test_yaml_that_another_launch_file_gives_to_a_node_is_told() -> None:
    entry = '<param from="$(find-pkg-share my_pkg)/config/fix.yaml"/>'
    other = f'<launch><node pkg="my_pkg" exec="fixer">{entry}</node></launch>'
    assert {"PRM006", "PRM007"} <= codes(LAUNCH, **{"launch/b.launch.xml": other})


VALUE = """\
<launch>
  <node pkg="my_pkg" exec="fixer"><param name="{}" value="$(find-pkg-share my_pkg)/config/fix.yaml"/></node>
</launch>
"""


def test_yaml_that_a_node_gets_as_the_value_of_a_parameter_is_opened_by_its_code() -> None:
    assert codes(LAUNCH, **{"launch/b.launch.xml": VALUE.format("config_file")}) == set()
    assert codes(LAUNCH.replace("'fix.yaml'", "'b.yaml'"), **{"launch/b.launch.xml": VALUE.format("config")}) == set()
    assert {"PRM006", "PRM007"} <= codes(LAUNCH, **{"launch/b.launch.xml": VALUE.format("arm_controller.params_file")})


PYTHON = "import yaml\n\nwith open(share() + '/config/fix.yaml') as f:\n    config = yaml.safe_load(f)['/**']\n"
CPP = '#include <yaml-cpp/yaml.h>\nint main() { YAML::LoadFile(share() + "/config/fix.yaml"); }\n'


@pytest.mark.parametrize(("path", "text"), [("scripts/a.py", PYTHON), ("src/a.cpp", CPP)])
def test_yaml_that_a_program_opens(path: str, text: str) -> None:
    plain = LAUNCH.replace("'fix.yaml'", "'other.yaml'")
    assert codes(plain, **{path: text}) == set()
    assert codes(plain, **{path: text.replace("fix.yaml", "other.yaml")}) >= {"PRM006"}
    assert codes(plain, **{path: text + "\n// automatically_declare_parameters_from_overrides\n"}) >= {"PRM006"}
    assert codes(plain, **{f"test/{path}": text}) >= {"PRM006"}


READ = """\
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml
from somewhere import RobotConfig, read_yaml


def setup(context):
    folder = LaunchConfiguration('folder').perform(context)
    robot = RobotConfig(read_yaml(os.path.join(folder, 'fix.yaml')))
    rest = RewrittenYaml(source_file=os.path.join(folder, 'rest.yaml'), param_rewrites={'a': robot.a})
    return [Node(package='my_pkg', executable='fixer', parameters=[rest])]


def generate_launch_description():
    folder = DeclareLaunchArgument('folder', default_value='', description='The folder with fix.yaml and others.')
    return LaunchDescription([folder, OpaqueFunction(function=setup)])
"""
JOINED = "os.path.join(folder, 'fix.yaml')"
HELD = READ.replace("    robot =", f"    path = {JOINED}\n    robot =").replace(f"yaml({JOINED})", "yaml(path)")


@pytest.mark.parametrize("launch", [READ, HELD])
def test_yaml_of_an_unknown_folder_that_a_launch_file_reads(launch: str) -> None:
    assert codes(launch) == set()
    assert codes(launch.replace("read_yaml(", "shown(")) >= {"PRM006"}
    assert codes(launch.replace("[rest]", f"[rest, {JOINED}]")) >= {"PRM006"}
    assert codes(launch.replace("[rest]", "[robot, read_yaml(folder)]")) >= {"PRM006"}


def test_a_name_that_is_held_and_given_on() -> None:
    assert codes(HELD.replace("read_yaml(path)", "show()")) >= {"PRM006"}
    assert codes(HELD.replace("param_rewrites={'a': robot.a}", "param_rewrites={'a': path}")) >= {"PRM006"}


ITEMS = "sensors:\n  lidar:\n  - model: a\n    ros_parameters:\n      driver:\n        port: 1\nversion: 0\n"
MACHINE = "serial_number: a-1\nplatform:\n  extras:\n    ros_parameters:\n      controller:\n        port: 1\n"


@pytest.mark.parametrize("text", [ITEMS, MACHINE])
def test_yaml_of_another_kind_with_parameters_further_in(text: str) -> None:
    launch = LAUNCH.replace("'fix.yaml'", "'other.yaml'")
    assert codes(launch, **{"config/fix.yaml": text}) == set()
    given = '<launch><node pkg="a" exec="b"><param from="$(find-pkg-share my_pkg)/config/fix.yaml"/></node></launch>'
    assert codes(launch, **{"config/fix.yaml": text, "launch/b.launch.xml": given}) >= {"PRM004"}


@pytest.mark.parametrize("text", [ITEMS.replace("_p", "__p"), MACHINE.replace("serial_number", "number")])
def test_yaml_with_a_key_that_is_meant_for_rcl(text: str) -> None:
    assert codes(LAUNCH.replace("'fix.yaml'", "'other.yaml'"), **{"config/fix.yaml": text}) != set()
