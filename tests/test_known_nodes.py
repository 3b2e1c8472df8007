"""Values for nodes, controllers and plugins of well-known packages, whose sources are not here."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.params.known_names import is_slip
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.languages.cpp.file import read_cpp
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.package.params import cpp_parameters as cpp
from rospkg_cli.package.params import python_parameters as python
from rospkg_cli.ros.known_nodes import KnownParameter, known_parameters
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

RATE = 15


def generate_launch_description():
    return LaunchDescription([Node(package='{}', executable='x', name='x', parameters=[{}])])
"""
MANAGER = (
    "controller_manager:\n  ros__parameters:\n    arm: {type: joint_trajectory_controller/JointTrajectoryController}\n"
)


def package(launch: str, values: str, others: dict[str, str]) -> dict[str, str]:
    files = {
        "src/my_pkg/package.xml": manifest("", "ament_cmake"),
        "src/my_pkg/CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "src/my_pkg/launch/a.launch.py": launch,
        "src/my_pkg/config/a.yaml": values,
    }
    return files | others


def said(launch: str = "", values: str = "", **others: str) -> list[str]:
    found = lint_files(package(launch, values, others), ["PRM006", "PRM007"]).findings
    return [f"{each.code} {each.message}" for each in found]


@pytest.mark.parametrize(
    "values, starts",
    [
        ("{'delay_between_messages': 0}", []),
        ("{'delay_between_messages': 0.0, 'websocket_ping_interval': 10.0}", []),
        ("{'port': '9090'}", ["PRM006 `port` is declared as int by `rosbridge_server`: a string"]),
        ("{'default_call_service_timeout': 5}", []),
        ("{'actions_glob': '[]', 'binary_encoder_type': 'b64'}", []),
    ],
)
def test_releases_of_one_distribution_may_declare_a_parameter_otherwise(values: str, starts: list[str]) -> None:
    found = said(LAUNCH.format("rosbridge_server", values))
    assert [each.startswith(start) for each, start in zip(found, starts, strict=True)] == [True] * len(starts)


@pytest.mark.parametrize(
    "values, starts",
    [
        ("{'deadzone': 0}", ["PRM006 `deadzone` is declared as double by `joy`: an int stops the node"]),
        ("{'deadzone': '0'}", ["PRM006 `deadzone` is declared as double"]),
        ("{'deadzone': 0.0, 'device_id': 1.5}", ["PRM006 `device_id` is declared as int by `joy`: a double"]),
        ("{'sticky_buttons': 1}", ["PRM006 `sticky_buttons` is declared as bool"]),
        ("{'sticky_buttons': True, 'device_name': 'pad'}", []),
        ("{'deadzone': ParameterValue(0, value_type=float)}", []),
        ("{'deadzone': [0]}", []),
        ("{'deadzone': RATE}", []),
        ("{'other': 1}", []),
        ("{'deadzon': 0.1}", ["PRM007 `joy` declares no parameter `deadzon`: the value is dropped; did you mean"]),
        ("{'/deadzone': 0.1}", ["PRM007 `joy` declares no parameter `/deadzone`"]),
        ("{'autorepeatrate': 0.1}", ["PRM007 `joy` declares no parameter `autorepeatrate`"]),
        ("{'deadzon': 0.1, 'deadzone': 0.1}", []),
        ("{'deadzon': 0.1, 'one': 1, 'two': 2}", []),
        ("{'use_sime_time': True}", ["PRM007 no node has a parameter `use_sime_time`: the value is dropped"]),
        ("{'/use_sim_time': True}", ["PRM007 no node has a parameter `/use_sim_time`"]),
        ("{'use_sim_time': True}", []),
    ],
)
def test_values_in_launch_files(values: str, starts: list[str]) -> None:
    for text, start in zip(said(LAUNCH.format("joy", values)), starts, strict=True):
        assert text.startswith(start)


def test_nothing_is_said_of_a_package_whose_sources_are_here() -> None:
    own = {"src/joy/package.xml": manifest("", "ament_cmake", "joy")}
    assert said(LAUNCH.format("joy", "{'deadzone': 0, 'deadzon': 0.1}"), **own) == []


@pytest.mark.parametrize(
    "values, starts",
    [
        (MANAGER + "arm:\n  ros__parameters:\n    constraints: {goal_time: 0.5, tip: {trajectory: 1}}\n",
         ["PRM006 `constraints.tip.trajectory` is declared as double by `joint_trajectory_controller`: an int stops "
          "the controller when it starts; write a double"]),
        (MANAGER + "arm:\n  ros__parameters:\n    interpolation_method: [none, splines]\n",
         ["PRM006 `interpolation_method` is declared as string by `joint_trajectory_controller`: a list of string"]),
        ("arm:\n  ros__parameters:\n    constraints: {goal_time: 0.5, tip: {trajectory: 1}}\n", []),
        ("map_saver:\n  ros__parameters:\n    save_map_timeout: 5000\n", ["PRM006 `save_map_timeout` is declared"]),
        ("/robot/map_saver:\n  ros__parameters:\n    save_map_timeout: <TIMEOUT>\n", []),
        ("map_saver:\n  ros__parameters:\n    save_map_timeout: SAVE_TIMEOUT\n", []),
        ("map_saver:\n  ros__parameters:\n    save_map_timeout: ten\n", ["PRM006 `save_map_timeout` is declared"]),
        ("planner_server:\n  ros__parameters:\n    Grid:\n      plugin: nav2_navfn_planner::NavfnPlanner\n"
         "      tolerance: 1\n", ["PRM006 `Grid.tolerance` is declared as double by `nav2_navfn_planner`: an int"]),
        ("planner_server:\n  ros__parameters:\n    Grid:\n      plugin: nav2_navfn_planner::NavfnPlanner\n"
         "      tolerence: 1.0\n", ["PRM007 `nav2_navfn_planner` declares no parameter `Grid.tolerence`"]),
        ("planner_server:\n  ros__parameters:\n    Grid:\n      plugin: my_pkg::Planner\n      tolerance: 1\n", []),
        ("joystick:\n  ros__parameters:\n    use_sim_tim: true\n", ["PRM007 no node has a parameter `use_sim_tim`"]),
    ],
)  # fmt: skip
def test_values_in_parameter_files(values: str, starts: list[str]) -> None:
    for text, start in zip(said("", values), starts, strict=True):
        assert text.startswith(start)


@pytest.mark.parametrize(
    "package, given, found", [("joy", "x", 1), ("joy", "y", 0), ("joy", "/**", 1), ("my_pkg", "x", 0)]
)
def test_the_launch_file_says_whose_block_it_is(package: str, given: str, found: int) -> None:
    launch = (
        "<launch>\n  <node pkg='{}' exec='x' name='x'>\n    <param from='$(find-pkg-share my_pkg)/config/a.yaml'/>\n"
    )
    files = {"src/my_pkg/launch/b.launch.xml": launch.format(package) + "  </node>\n</launch>\n"}
    assert len(said("", f"{given}:\n  ros__parameters:\n    deadzone: 0\n", **files)) == found


def test_a_parameter_that_a_package_here_declares_is_no_slip_of_the_clock() -> None:
    code = {"src/my_pkg/src/a.cpp": 'void f() { declare_parameter("use_sim_times", true); }\n'}
    assert said("", "x:\n  ros__parameters:\n    use_sim_times: true\n", **code) == []


def test_parameters_of_a_table_fit_names() -> None:
    (trajectory,) = (each for each in known_parameters("joint_trajectory_controller") if each.name == "trajectory")
    assert trajectory == KnownParameter("trajectory", True, "double")
    assert trajectory.fits("constraints.a.trajectory")
    assert not trajectory.fits("trajectory")
    assert KnownParameter("_config", True, "bool[]").fits("odom0_config")
    assert known_parameters("nobody_knows_it") == ()


def test_several_parameters_declared_at_once() -> None:
    text = 'void f() { declare_parameters<double>("gains", {{"p", 1.0}, {"i", 0.1}}); }'
    found = cpp.declared_in(read_cpp(Source("a.cpp", text)), lambda _: "")
    assert [(each.name, each.type) for each in found] == [("gains.p", "double"), ("gains.i", "double")]
    text = 'void f() { declare_parameters("", {{"p", 1.0}}); declare_parameters(space, {{"i", 1}}); }'
    found = cpp.declared_in(read_cpp(Source("a.cpp", text)), lambda _: "")
    assert [(each.name, each.type) for each in found] == [("p", "")]


@pytest.mark.parametrize(
    "name, found",
    [
        ('name_ + "." + "rate"', [(".rate", True)]),
        ('name_ + "." + id + ".rate"', [(".rate", True)]),
        ('"a." "b"', []),
        ('is_fast ? "a" : "b"', []),
    ],
)
def test_names_that_are_put_together(name: str, found: list[tuple[str, bool]]) -> None:
    declared = cpp.declared_in(read_cpp(Source("a.cpp", f"void f() {{ declare_parameter({name}, 1); }}")), lambda _: "")
    assert [(each.name, each.tail) for each in declared] == found


def test_a_layer_puts_its_name_before_that_of_a_parameter() -> None:
    text = 'void f() { declareParameter("enabled", rclcpp::ParameterValue(true)); }'
    (found,) = cpp.declared_in(read_cpp(Source("a.cpp", text)), lambda _: "")
    assert (found.name, found.tail, found.type) == ("enabled", True, "bool")


def test_constants_as_defaults() -> None:
    file = parse_python(Source("a.py", "RATE = 1.5\nclass Talker:\n    size: int = 3\n    def f(self): pass\n"))
    types = dict(python.constants_in(file))
    assert types == {"RATE": "double", "size": "int"}
    code = "".join(f"self.declare_parameter('a', {each})\n" for each in ("RATE", "Talker.size", "self.size"))
    found = python.declared_in(parse_python(Source("a.py", code)), lambda name: types.get(name, ""))
    assert [each.type for each in found] == ["double", "int", ""]


STARTED = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    file = {file}
    return LaunchDescription([
        Node(package='my_pkg', executable='talk', {talker}, parameters=[file]),
        Node(package='my_pkg', executable='listen', name='listener', parameters=[file]),
    ])
"""
SHARE = "[FindPackageShare('my_pkg'), '/config/a.yaml']"


@pytest.mark.parametrize(
    "key, talker, file, found",
    [
        ("talker", "name='talker', namespace='robot'", SHARE, "`talker` is no node: the one that"),
        ("talker", "name='talker', namespace='/'", SHARE, ""),
        ("talker", "name='talker'", SHARE, ""),
        ("/other/talker", "name='talker', namespace='robot'", SHARE, "`/other/talker` is no node: the one that"),
        ("/fleet/robot/talker", "name='talker', namespace='robot'", SHARE, ""),
        ("robot/talker", "name='talker', namespace='robot'", SHARE, ""),
        ("/**/talker", "name='talker', namespace='robot'", SHARE, ""),
        ("/other/talker", "name='talker', namespace=file", SHARE, ""),
        ("talk", "name='talker'", SHARE, "no node is called `talk`: the one that"),
        ("shout", "name='talker'", SHARE, ""),
        ("talk", "name='talker'", "'/home/me/src/my_pkg/config/a.yaml'", "no node is called `talk`: the one that"),
        ("talk", "name='talker'", "'/home/me/src/other/config/a.yaml'", ""),
    ],
)
def test_blocks_of_nodes_with_another_name(key: str, talker: str, file: str, found: str) -> None:
    blocks = f"{key}:\n  ros__parameters:\n    a: 1\nlistener:\n  ros__parameters:\n    a: 1\n"
    files = package(STARTED.format(talker=talker, file=file), blocks, {})
    texts = [each.message for each in lint_files(files, ["PRM003"]).findings]
    assert len(texts) == bool(found)
    assert all(text.startswith(found) for text in texts)


READING = """\
#include <rclcpp/rclcpp.hpp>
int main() {{
  auto node = rclcpp::Node::make_shared("talker");
  node->declare_parameter("rate", 1.0);
  node->declare_parameter("frame", "map");
  node->declare_parameter("count", 1);
  node->get_parameter("rate", rate);
  node->get_parameter("frame", frame);
  node->get_parameter("count", count);
  {}
}}
"""
FORGOTTEN = ["nothing declares the parameter `mode`: the variable is never set; declare it, as the others here"]


@pytest.mark.parametrize(
    "code, others, found",
    [
        ('node->get_parameter("mode", mode);', {}, FORGOTTEN),
        ('node->get_parameter("mode", mode); node->get_parameter("size", size); load("mode", "size");', {}, []),
        ('node->get_parameter("mode", mode); node->declare_parameter(name, 1);', {}, []),
        ('node->get_parameter("mode", mode); node->declare_parameters("", all);', {}, []),
        ('node->get_parameter("mode", mode); SyncParametersClient other;', {}, []),
        ('node->get_parameter("use_sim_time", mode);', {}, []),
        ('node->get_parameter("mode", mode);', {"b.cpp": 'void f() { declare_parameter("mode", 1); }'}, []),
        ('node->get_parameter("mode", mode);', {"b.cpp": 'int main() { declare_parameter("mode", 1); }'}, FORGOTTEN),
    ],
)
def test_a_parameter_that_a_program_forgets_to_declare(code: str, others: dict[str, str], found: list[str]) -> None:
    sources = {f"src/my_pkg/src/{name}": text for name, text in others.items()}
    files = {"src/my_pkg/package.xml": manifest("", "ament_cmake"), "src/my_pkg/src/a.cpp": READING.format(code)}
    build = CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package")
    hits = lint_files({**files, "src/my_pkg/CMakeLists.txt": build, **sources}, ["PRM007"]).findings
    assert [each.message for each in hits] == found
    assert all(each.severity.value == "warning" for each in hits)


def test_a_file_that_makes_no_node_may_read_anything() -> None:
    files = {"src/my_pkg/package.xml": manifest("", "ament_cmake"), "src/my_pkg/CMakeLists.txt": CMAKE}
    text = READING.format('node->get_parameter("mode", mode);').replace("Node::make_shared", "Other::make_shared")
    assert lint_files({**files, "src/my_pkg/src/a.cpp": text}, ["PRM007"]).findings == ()


@pytest.mark.parametrize(
    "arguments, found",
    [
        (
            "['wheel', '--controller-manager', '/cm']",
            ["no controller manager here has a controller `wheel`: the spawner"],
        ),
        ("['wheels']", []),
        ("['--controller-manager', 'wheel']", []),
        ("['other']", []),
        ("[file]", []),
    ],
)
def test_controllers_that_are_spawned_under_nearly_their_name(arguments: str, found: list[str]) -> None:
    node = f"Node(package='controller_manager', executable='spawner', arguments={arguments})"
    launch = STARTED.format(talker="name='x'", file=SHARE).replace("LaunchDescription([", f"LaunchDescription([{node},")
    values = "controller_manager:\n  ros__parameters:\n    wheels: {type: diff_drive_controller/DiffDriveController}\n"
    texts = [each.message for each in lint_files(package(launch, values, {}), ["PRM003"]).findings]
    assert len(texts) == len(found)
    assert all(text.startswith(start) for text, start in zip(texts, found, strict=True))


def test_a_parameter_of_older_releases_is_an_info() -> None:
    values = "controller_server:\n  ros__parameters:\n    controller_frequency: 20.0\n    goal_checker_plugin: x\n"
    (found,) = lint_files(package("", values, {}), ["PRM007"]).findings
    assert found.severity.value == "info"
    assert found.message.startswith("`nav2_controller` declares no parameter `goal_checker_plugin` any more: the value")


@pytest.mark.parametrize(
    "name, right, found",
    [
        ("base_frame", "base_frame_id", True),
        ("base_frame_id", "base_frame", True),
        ("base_frame", "base_frame_prefix", False),
        ("max_rate", "min_rate", False),
        ("goal_tolerence", "goal_tolerance", True),
        ("tolerance_goal", "goal_tolerance", True),
        ("goaltolerance", "goal_tolerance", True),
        ("Goal_Tolerance", "goal_tolerance", True),
        ("goal_x", "goal_y", False),
        ("camera_name", "camera", False),
        ("camera", "camera_name", True),
        ("output_frame_id", "output_frame", True),
    ],
)
def test_slips_in_names(name: str, right: str, found: bool) -> None:
    assert is_slip(name, right) is found


def test_a_prefix_may_stand_before_a_name() -> None:
    launch = LAUNCH.format("moveit_servo", "{'moveit_servo.use_smoothing': True, 'moveit_servo.scale': 1.0}")
    assert said(launch) == []
