"""Slips in launch files: blanks in names, modules of launch, values among parameter files, types of a bridge."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = """\
import launch
import launch_ros.actions
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([{}])
"""


def said(path: str, text: str, code: str, **others: str) -> list[str]:
    files = {"src/my_pkg/package.xml": manifest(others.pop("needs", "")), f"src/my_pkg/{path}": text, **others}
    return [f"{each.severity.value}: {each.message}" for each in lint_files(files, [code, "RPK005"]).findings]


def in_python(*actions: str, code: str) -> list[str]:
    return said("launch/a.launch.py", HEAD.format(", ".join(actions)), code)


@pytest.mark.parametrize(
    "node, found",
    [
        (
            "package='joy ', executable='joy_node'",
            ["error: no package is called `joy `, with a blank: it is not found"],
        ),
        ("package='joy', executable=' joy_node'", ["error: `joy` has no executable ` joy_node`"]),
        ("package=' ', executable='joy_node'", ["error: the package of this node is empty"]),
        ("package='', executable='joy_node'", ["error: the package of this node is empty"]),
        ("package='joy', executable='joy_node'", []),
    ],
)
def test_blanks_at_the_end_of_a_name(node: str, found: list[str]) -> None:
    for text, start in zip(in_python(f"Node({node})", code="LCH002"), found, strict=True):
        assert text.startswith(start)


@pytest.mark.parametrize(
    "action, found",
    [
        ("launch.action.LogInfo(msg='x')", "`launch` has no `action`: the launch stops with AttributeError; did you"),
        ("launch.actions.LogInf(msg='x')", "`launch.actions` has no `LogInf`"),
        ("launch_ros.action.Node()", "`launch_ros` has no `action`"),
        ("launch.substitution.LaunchConfiguration('a')", "`launch` has no `substitution`"),
        ("launch.actions.LogInfo(msg='x')", ""),
        ("launch.LaunchDescription([])", ""),
        ("launch.utilities.perform(1)", ""),
        ("launch.something.else_()", ""),
    ],
)  # fmt: skip
def test_modules_of_launch_by_a_name_that_they_do_not_have(action: str, found: str) -> None:
    texts = in_python(action, code="LCH013")
    assert len(texts) == bool(found)
    assert all(text.startswith(f"error: {found}") for text in texts)


def test_a_name_that_is_no_module_has_any_attribute() -> None:
    text = HEAD.replace("import launch\n", "from x import launch\n").format("launch.action.LogInfo()")
    assert said("launch/a.launch.py", text, "LCH013") == []


@pytest.mark.parametrize(
    "default, found",
    [("192.168.0.2", 1), ("12", 1), ("robot.yaml", 0), ("/etc/robot", 0), ("", 0), ("~params", 0), ("robot.params", 0)],
)
def test_a_value_that_stands_for_a_parameter_file(default: str, found: int) -> None:
    node = "Node(package='p', executable='e', parameters=[LaunchConfiguration('address')])"
    texts = in_python(f"DeclareLaunchArgument('address', default_value='{default}')", node, code="LCH014")
    start = f"warning: `address` stands among parameters, where launch_ros takes files; its default `{default}` is none"
    assert len(texts) == found
    assert all(text.startswith(start) for text in texts)


@pytest.mark.parametrize("name", ["config_file", "params_path", "robot_yaml", "parameters"])
def test_an_argument_that_is_named_for_a_file_is_given_one(name: str) -> None:
    node = f"Node(package='p', executable='e', parameters=[LaunchConfiguration('{name}')])"
    assert in_python(f"DeclareLaunchArgument('{name}', default_value='not given')", node, code="LCH014") == []


def test_what_is_compared_is_named() -> None:
    (text,) = in_python("Node(package='p', executable='e') if LaunchConfiguration('mode') == 'x' else 1", code="LCH014")
    assert "it compares `LaunchConfiguration('mode')` itself" in text


@pytest.mark.parametrize("operator, better", [("&", "AndSubstitution"), ("|", "OrSubstitution")])
def test_conditions_have_no_operators(operator: str, better: str) -> None:
    one = "launch.conditions.IfCondition(LaunchConfiguration('a', default='true'))"
    node = f"Node(package='p', executable='e', condition={one} {operator} {one})"
    (text,) = in_python(node, code="LCH014")
    assert text.startswith(f"error: `{operator}` raises TypeError for `IfCondition`")
    assert text.endswith(f"write `IfCondition({better}(a, b))`")
    assert in_python(f"Node(package='p', executable='e', condition=x {operator} y)", code="LCH014") == []


@pytest.mark.parametrize("word, found", [("roz_gz_interfaces", 1), ("ros_gz_interfaces", 0), ("my_gz_types", 0)])
def test_a_service_of_a_bridge_is_of_a_package(word: str, found: int) -> None:
    node = f"Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=['/x@{word}/srv/SpawnEntity'])"
    assert len(in_python(node, code="LCH019")) == found


@pytest.mark.parametrize(
    "word, found",
    [
        ("/odom@gz.msgs.Odometry[nav_msgs/msg/Odometry", "write `nav_msgs/msg/Odometry[gz.msgs.Odometry`"),
        ("/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry", ""),
        ("/odom@nav_msgs/msg/Odometry@ignition.msgs.OdometryWithCovariance", ""),
        ("/imu@sensor_msgs/msg/Imu[gz.msgs.Imu", "goes with `gz.msgs.IMU`, not with `gz.msgs.Imu`"),
        ("/tf@tf2_msgs/msg/TFMessage[gz.msgs.Odometry", "goes with `gz.msgs.Pose_V`"),
        ("/tf@tf2_msgs/msg/TFMessage[gz.msgs.SomethingNew", ""),
        ("/r@sensor_msgs/msg/Range[gz.msgs.LaserScan", ""),
        ("/x@std_msgs/msg/Bool", "write `std_msgs/msg/Bool[gz.msgs.Boolean`"),
        ("/x@std_msgs/msg/Bool>gz.msgs.Boolean", "`>` is no direction"),
        ("/clock@gz.msgs.Clock", "without the type of ROS"),
        ("/x@ros_gz_interfaces/srv/ControlWorld@gz.msgs.WorldControl@gz.msgs.Boolean", ""),
        ("/x@ros_gz_interfaces/srv/ControlWorld", ""),
        ("user@example", ""),
    ],
)
def test_pairs_of_types_of_a_bridge(word: str, found: str) -> None:
    node = f"Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=['{word}'])"
    texts = in_python(node, code="LCH019")
    assert len(texts) == bool(found)
    assert all(found in text for text in texts)


@pytest.mark.parametrize(
    "ros, gazebo, found",
    [
        ("sensor_msgs/msg/Imu", "gz.msgs.Imu", "goes with `gz.msgs.IMU`"),
        ("gz.msgs.Clock", "rosgraph_msgs/msg/Clock", "exchange it with `rosgraph_msgs/msg/Clock`"),
        ("rosgraph_msgs/msg/Clock", "gz.msgs.Clock", ""),
    ],
)
def test_pairs_of_types_in_a_config_of_a_bridge(ros: str, gazebo: str, found: str) -> None:
    texts = said("config/b.yaml", f"- topic_name: a\n  ros_type_name: {ros}\n  gz_type_name: {gazebo}\n", "LCH019")
    assert len(texts) == bool(found)
    assert all(found in text for text in texts)


def test_what_is_read_twice_is_told_once_and_mended_once() -> None:
    """Substitutions in the condition of a group are found with the group, and with what is inside of it."""
    text = '<launch>\n  <group if="$(arg on)">\n    <node pkg="p" exec="e"/>\n  </group>\n</launch>\n'
    (found,) = said("launch/a.launch.xml", text, "LCH006")
    assert found.startswith("error: `$(arg on)` is ROS 1's")


@pytest.mark.parametrize(
    "name, needed, found",
    [
        ("obotiq_controllers/Gripper", "robotiq_controllers", "write `robotiq_controllers/Gripper`"),
        ("obotiq_controllers::Gripper", "robotiq_controllers", ""),
        ("robotiq_controllers/Gripper", "robotiq_controllers", ""),
        ("arm_controllers/Gripper", "robotiq_controllers", ""),
        ("arm1_controllers/Gripper", "arm2_controllers", ""),
        ("my_pkg/Gripper", "my_pkgs", ""),
    ],
)
def test_a_plugin_of_nearly_a_package_that_is_depended_on(name: str, needed: str, found: str) -> None:
    text = f"controller_manager:\n  ros__parameters:\n    gripper:\n      type: {name}\n"
    texts = said("config/a.yaml", text, "PLG003", needs=f"  <exec_depend>{needed}</exec_depend>\n")
    assert len(texts) == bool(found)
    assert all(text.endswith(found) for text in texts)


@pytest.mark.parametrize(
    "package, name, found",
    [
        (
            "slam_toolbox",
            "sync_slam_toolbox",
            "error: `slam_toolbox` has no executable `sync_slam_toolbox`: the launch",
        ),
        ("gazebo_ros", "spawn_entity", "error: `gazebo_ros` has no executable `spawn_entity`: the launch stops with"),
        ("joint_state_publisher", "joint_state_publisher_gui", "warning: `joint_state_publisher` has no executable"),
        ("slam_toolbox", "other_program", ""),
        ("not_known", "joint_state_publisher_gui", ""),
        ("slam_toolbox", "rviz2", ""),
    ],
)
def test_programs_by_another_ending_or_of_another_package(package: str, name: str, found: str) -> None:
    texts = in_python(f"Node(package='{package}', executable='{name}')", code="LCH002")
    assert len(texts) == bool(found)
    assert all(text.startswith(found) for text in texts)


@pytest.mark.parametrize(
    "package, path, better",
    [
        ("slam_toolbox", "launch/online_async.launch.py", "launch/online_async_launch.py"),
        ("slam_toolbox", "launch/online_asyn_launch.py", "launch/online_async_launch.py"),
        ("slam_toolbox", "launch/online_async_launch.xml", "launch/online_async_launch.py"),
        ("slam_toolbox", "online_async_launch.py", "launch/online_async_launch.py"),
        ("slam_toolbox", "launch/online_async_launch.py", ""),
        ("slam_toolbox", "launch/mapping.launch.py", ""),
        ("not_known", "launch/online_async.launch.py", ""),
    ],
)
def test_launch_files_of_well_known_packages(package: str, path: str, better: str) -> None:
    text = f'<launch>\n  <include file="$(find-pkg-share {package})/{path}"/>\n</launch>\n'
    texts = said("launch/a.launch.xml", text, "LCH003")
    assert len(texts) == bool(better)
    start = f"warning: `{package}` has no file `{path}`: the launch stops"
    assert all(each.startswith(start) and each.endswith(f"did you mean `{better}`?") for each in texts)


def test_launch_files_of_a_package_that_is_here_are_those_of_its_sources() -> None:
    text = '<launch>\n  <include file="$(find-pkg-share slam_toolbox)/launch/online_async.launch.py"/>\n</launch>\n'
    own = {"src/slam_toolbox/package.xml": manifest("", "ament_cmake", "slam_toolbox")}
    assert not any("online_async_launch" in each for each in said("launch/a.launch.xml", text, "LCH003", **own))


@pytest.mark.parametrize(
    "package, ends", [("slam_toolbx", "did you mean `slam_toolbox`?"), ("other_thing", "in a .repos file")]
)
def test_a_package_that_nobody_has_is_perhaps_another(package: str, ends: str) -> None:
    texts = in_python(f"Node(package='{package}', executable='e')", code="DEP103")
    assert any(text.endswith(ends) for text in texts)


LOCAL = "LogInfo(msg=LaunchConfiguration('{}', default='5'))"


@pytest.mark.parametrize(
    "used, declared, more, levels",
    [
        ("use_sim_time", "use_sim_tim", "", ["warning"]),
        ("use_sim_time", "use_sim_tim", ", launch.actions.IncludeLaunchDescription('/opt/a.launch.py')", ["info"]),
        ("use_sim_time", "use_sim_tim", ", LogInfo(msg=LaunchConfiguration('use_sim_tim'))", []),
        ("use_sim_time", "use_sim_tim", ", LogInfo(msg='use_sim_time')", []),
        ("use_sim_time", "use_sim_time", "", []),
        ("use_sim_time", "use_clock", "", []),
        ("robot_1", "robot_2", "", []),
        ("gui", "gut", "", []),
    ],
)
def test_a_default_that_hides_a_slip(used: str, declared: str, more: str, levels: list[str]) -> None:
    action = f"DeclareLaunchArgument('{declared}'), {LOCAL.format(used)}{more}"
    found = in_python(action, code="LCH008")
    assert [each.partition(":")[0] for each in found] == levels
    assert all(f"`{used}`" in each and f"`{declared}`" in each for each in found)


IN_CLASS = """\
import launch
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration


class Pipeline:
    def __init__(self, context):
        self.rate = LaunchConfiguration("rate").perform(context)
        self.mode = LaunchConfiguration("{used}"{default}).perform(context).lower() == "true"


def launch_setup(context):
    return [LogInfo(msg={made}(context).rate)]


def generate_launch_description():
    given = [DeclareLaunchArgument("rate"), {declared}]
    return launch.LaunchDescription([*given, OpaqueFunction(function=launch_setup)])
"""
DECLARED = 'DeclareLaunchArgument("use_depth_mode_cuda")'


@pytest.mark.parametrize(
    "used, declared, default, made, found",
    [
        ("other", "", "", "Pipeline", 1),
        ("rate", "", "", "Pipeline", 0),
        ("other", "", ", default='x'", "Pipeline", 0),
        ("other", "", "", "str", 0),
        ("other", "unknown()", "", "Pipeline", 0),
        ("use_depth_mode_ptv3", f"unknown(), {DECLARED}", "", "Pipeline", 1),
        (
            "use_depth_mode_ptv3",
            f"unknown(), {DECLARED}, LogInfo(msg=LaunchConfiguration('use_depth_mode_cuda'))",
            "",
            "str",
            0,
        ),
        ("ros_namespace", "", "", "Pipeline", 0),
    ],
)
def test_what_a_class_uses(used: str, declared: str, default: str, made: str, found: int) -> None:
    text = IN_CLASS.format(used=used, declared=declared, default=default, made=made)
    told = said("launch/a.launch.py", text, "LCH008")
    assert [each.startswith(f"info: no file declares the launch argument `{used}`") for each in told] == [True] * found


def test_a_slip_that_another_file_declares_as_well_is_none() -> None:
    text = HEAD.format(f"DeclareLaunchArgument('use_sim_tim'), {LOCAL.format('use_sim_time')}")
    other = {"src/my_pkg/launch/b.launch.py": HEAD.format("DeclareLaunchArgument('use_sim_tim')")}
    assert said("launch/a.launch.py", text, "LCH008", **other) == []
