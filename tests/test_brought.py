"""What a declared dependency brings can't be missing: one info for all of it, which names who brings it."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.depends.brought_dependencies import Brought, brought, brought_by, brought_by_others
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.finding import Finding, Safety
from rospkg_cli.package.package_facts import ActiveDependency, PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])


def found(code: str, body: str, **files: str) -> list[Finding]:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    return list(lint_files({**PYTHON, "package.xml": manifest(body), **named}, [code]).findings)


def around(body: str, text: str, **other: str) -> Finding:
    """Return what is said of my_pkg, beside which another package lies."""
    ((name, needs),) = other.items()
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files |= {"a/package.xml": manifest(body), "a/my_pkg/node.py": text}
    files |= {f"b/{path.replace('my_pkg', name)}": text.replace("my_pkg", name) for path, text in PYTHON.items()}
    files |= {"b/package.xml": manifest(needs, name=name), f"b/{name}/tool.py": "print(1)\n"}
    (finding,) = lint_files(files, ["DEP101"]).findings
    return finding


def declared(*names: str, tag: str = "exec_depend") -> str:
    return "".join(f"  <{tag}>{name}</{tag}>\n" for name in names)


def test_all_that_is_brought_is_one_info_and_one_fix() -> None:
    text = "import rclpy\nimport rcl_interfaces.msg\nimport std_msgs.msg\n"
    (finding,) = found("DEP101", declared("rclpy", "sensor_msgs"), my_pkg__a_DOT_py=text)
    assert finding.severity.value == "info"
    assert finding.message == (
        "`rcl_interfaces` and `std_msgs` are imported and not declared: they come with other dependencies today; "
        "declare what you use"
    )
    assert [what for _, what in finding.related] == ["`std_msgs` here, by way of `sensor_msgs`"]
    assert finding.fix is not None
    texts = [edit.text for edit in finding.fix.operations]
    assert texts == ["<exec_depend>rcl_interfaces</exec_depend>\n  ", "\n  <exec_depend>std_msgs</exec_depend>"]


@pytest.mark.parametrize("tag, level", [("exec_depend", "info"), ("depend", "info"), ("test_depend", "info"),
                                        ("build_depend", "info"), ("build_export_depend", "info"),
                                        ("doc_depend", "warning")])  # fmt: skip
def test_what_rosdep_installs_for_a_workspace_brings_something(tag: str, level: str) -> None:
    (finding,) = found("DEP101", declared("sensor_msgs", tag=tag), my_pkg__a_DOT_py="import std_msgs.msg\n")
    assert finding.severity.value == level


def test_what_holds_for_some_distributions_brings_nothing_for_certain() -> None:
    body = '  <exec_depend condition="$ROS_DISTRO == humble">sensor_msgs</exec_depend>\n'
    (finding,) = found("DEP101", body, my_pkg__a_DOT_py="import std_msgs.msg\n")
    assert finding.message == (
        "`std_msgs` is imported and not declared: it may come with `sensor_msgs`; declare what you use"
    )
    assert finding.severity.value == "info"


def test_anything_may_come_with_a_package_that_is_not_here() -> None:
    (finding,) = found("DEP101", declared("rclpy", "acme_driver"), my_pkg__a_DOT_py="import std_msgs.msg\n")
    assert ("it may come with `acme_driver`" in finding.message, finding.severity.value) == (True, "info")


def test_what_comes_with_others_for_certain_and_what_perhaps_is_one_info() -> None:
    text = "import nav_msgs.msg\nimport std_msgs.msg\n"
    (finding,) = found("DEP101", declared("sensor_msgs", "acme_driver"), my_pkg__a_DOT_py=text)
    said = "`std_msgs` and `nav_msgs` are imported and not declared: they come or may come with other dependencies;"
    assert finding.message.startswith(said)
    assert [each for _, each in finding.related] == ["`nav_msgs` here, perhaps by way of `acme_driver`"]
    assert finding.severity.value == "info"


@pytest.mark.parametrize("tag, level", [("exec_depend", "info"), ("depend", "info"), ("build_export_depend", "info"),
                                        ("build_depend", "info"), ("test_depend", "info")])  # fmt: skip
def test_the_workspace_is_asked_before_the_table(tag: str, level: str) -> None:
    finding = around(declared("acme_tools"), "import cv2\n", acme_tools=declared("python3-opencv", tag=tag))
    assert finding.severity.value == level
    assert ("in a release it is not installed" in finding.message) is (tag == "test_depend")


@pytest.mark.parametrize(("name", "level"), [("acme_msgs", "info"), ("sensor_msgs", "warning")])
def test_what_builds_a_package_that_is_nowhere_released_is_there(name: str, level: str) -> None:
    cmake = CMAKE.replace("ament_package", "find_package(rosidl_default_generators REQUIRED)\nament_package")
    files = {
        "a/package.xml": manifest(declared(name), "ament_cmake"),
        "a/CMakeLists.txt": cmake,
        "b/package.xml": manifest(declared("rosidl_default_generators", tag="build_depend"), "ament_cmake", name),
        "b/CMakeLists.txt": cmake.replace("my_pkg", name),
        "tracks.yaml": "tracks: {}\n",
    }
    (finding,) = lint_files(files, ["DEP104"]).findings
    assert finding.severity.value == level


def test_a_package_of_the_workspace_brings_what_its_manifest_says_alone() -> None:
    finding = around(declared("sensor_msgs"), "import std_msgs.msg\n", sensor_msgs="")
    assert finding.severity.value == "warning"


def test_colcon_brings_pytest() -> None:
    (finding,) = found("DEP102", "", test__test_a_DOT_py="import pytest\n")
    assert (finding.severity.value, "it comes with `colcon` today" in finding.message) == ("info", True)
    assert (
        found("DEP102", declared("ament_cmake_pytest", tag="test_depend"), test__test_a_DOT_py="import pytest\n") == []
    )


def test_what_ros2_launch_needs_is_there_wherever_it_is_run() -> None:
    text = "import yaml\nimport rclpy\nimport cv2\nimport launch\n\n\ndef generate_launch_description():\n    pass\n"
    messages = [finding.message for finding in found("DEP103", "", launch__a_DOT_launch_DOT_py=text)]
    opencv, ros2launch = sorted(messages)
    assert opencv.startswith("`python3-opencv` is not declared, and this launch file imports `cv2` of it: on a clean")
    assert "the launch stops with ModuleNotFoundError" in opencv
    assert ros2launch.startswith("this launch file needs `launch`, which nothing in package.xml brings")


def test_launch_is_not_asked_for_where_something_brings_it() -> None:
    text = "import launch\n\n\ndef generate_launch_description():\n    pass\n"
    assert found("DEP103", declared("launch_testing_ros"), launch__a_DOT_launch_DOT_py=text) == []


@pytest.mark.parametrize(("name", "count"), [("launch_testing_ros", 0), ("acme_launching", 1)])
def test_launch_is_asked_for_where_it_only_may_come_with_something(name: str, count: int) -> None:
    text = "import launch\n\n\ndef generate_launch_description():\n    pass\n"
    assert len(found("DEP103", declared(name), launch__a_DOT_launch_DOT_py=text)) == count
    tests = found("DEP102", declared(name, tag="test_depend"), test__test_a_DOT_py="import launch_testing\n")
    assert len(tests) == count


def test_a_dependency_for_running_covers_the_tests() -> None:
    text = '<launch><node pkg="joy" exec="joy_node"/></launch>\n'
    (finding,) = found("DEP103", "", launch__a_DOT_launch_DOT_xml=text, test__b_DOT_launch_DOT_xml=text)
    assert finding.location.path == "launch/a.launch.xml"


def test_a_key_of_pypi_is_not_safe_and_left_to_pip() -> None:
    code = "import mediapipe\n"
    (finding,) = found("DEP101", "", my_pkg__a_DOT_py=code)
    assert finding.fix is not None
    assert (finding.severity.value, finding.fix.safety) == ("info", Safety.UNSAFE)
    assert "prevents a release" in finding.message


def test_a_name_that_nobody_knows_is_not_declared_by_a_safe_fix() -> None:
    (finding,) = found(
        "DEP103", declared("ros2launch"), launch__a_DOT_launch_DOT_xml='<launch><node pkg="acme" exec="x"/></launch>\n'
    )
    assert finding.fix is not None
    assert finding.fix.safety is Safety.UNSAFE
    assert finding.message.endswith("list its repository in a .repos file")


@pytest.mark.parametrize(("name", "meant"), [("turtlesym", True), ("urtlesim", True), ("burtlesims", False)])
def test_what_begins_with_another_letter_is_another_package(name: str, meant: bool) -> None:
    text = f'<launch><node pkg="{name}" exec="x"/></launch>\n'
    (finding,) = found("DEP103", declared("ros2launch", "turtlesim"), launch__a_DOT_launch_DOT_xml=text)
    assert ("did you mean" in finding.message) is meant


def test_what_another_missing_one_brings_is_no_warning() -> None:
    text = "import rclpy\nimport rcl_interfaces.msg\nimport cv2\n"
    found_levels = {f.message.split("`")[1]: f.severity.value for f in found("DEP101", "", my_pkg__a_DOT_py=text)}
    assert found_levels == {"rclpy": "warning", "python3-opencv": "warning", "rcl_interfaces": "info"}


def test_a_library_of_boost_brings_the_headers_of_all() -> None:
    assert brought_by(["libboost-thread-dev"], Workspace())["libboost-dev"] == "libboost-thread-dev"


def test_of_two_that_bring_each_other_one_is_asked_for() -> None:
    workspace = Workspace((package("a", "b"), package("b", "a"), package("c", "d"), package("d")))
    assert brought_by_others(["a", "b", "c", "d"], workspace) == {"a": "b", "d": "c"}
    assert brought_by(["a"], workspace) == {"b": "a", "a": "a"}


def test_what_is_there_at_run_time_and_at_any_time() -> None:
    tags = ("build_depend", "exec_depend", "test_depend", "doc_depend")
    needs = [
        ActiveDependency(tag, f"{tag[:4]}_{certain}", certain=certain) for tag in tags for certain in (True, False)
    ]
    facts = PackageFacts("a", "a", dependencies=tuple(needs))
    workspace = Workspace((facts,))
    assert brought_by(["a"], workspace) == {"exec_True": "a"}
    assert brought(["a"], [], workspace).perhaps == {"exec_False": "a"}


def test_what_comes_along_under_a_condition_brings_others() -> None:
    needs = (ActiveDependency("depend", "b", certain=False), ActiveDependency("depend", "c"))
    workspace = Workspace((PackageFacts("a", "a", dependencies=needs), package("b", "d", "c"), package("c", "e")))
    found = brought(["a"], ["f"], workspace)
    assert found == Brought({"c": "a", "e": "a"}, {"f": "f", "b": "a", "d": "a"}, ("e", "f", "d"), ())
    assert [found.may_bring(name, workspace) for name in ("b", "d", "g")] == ["a", "a", "e"]


def test_a_key_brings_no_package_of_ros_and_python_no_library() -> None:
    found = brought(["python3-mediapipe-pip", "ignition-gui6"], [], Workspace())
    assert found.unknown == ()
    asked = ("rclpy", "python3-numpy", "eigen", "acme")
    assert [found.may_bring(name, Workspace()) for name in asked] == ["", "python3-mediapipe-pip", "ignition-gui6", ""]


def package(name: str, *needs: str) -> PackageFacts:
    return PackageFacts(name, name, dependencies=tuple(ActiveDependency("exec_depend", need) for need in needs))


CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
"""


@pytest.mark.parametrize("node, level", [("controller_manager", "warning"), ("robot_state_publisher", "info")])
def test_plugins_of_parameters_count_where_something_loads_them(node: str, level: str) -> None:
    launch = f'<launch><node pkg="{node}" exec="spawner"><param from="config/c.yaml"/></node></launch>\n'
    files = {"config__c_DOT_yaml": CONTROLLERS, "launch__a_DOT_launch_DOT_xml": launch}
    (finding,) = found("DEP106", declared(node), **files)
    assert finding.severity.value == level


@pytest.mark.parametrize(
    "plugin, package",
    [
        ("position_controllers/GripperActionController", "gripper_controllers"),
        ("position_controllers/JointGroupPositionController", "position_controllers"),
        ("parallel_gripper_action_controller/GripperActionController", "parallel_gripper_controller"),
    ],
)
def test_some_plugins_are_of_another_package_than_they_are_called_after(plugin: str, package: str) -> None:
    launch = '<launch><node pkg="controller_manager" exec="x"/></launch>\n'
    text = CONTROLLERS.replace("joint_trajectory_controller/JointTrajectoryController", plugin)
    files = {"config__c_DOT_yaml": text, "launch__a_DOT_launch_DOT_xml": launch}
    (finding,) = found("DEP106", declared("controller_manager"), **files)
    assert finding.message.startswith(f"`{package}` is not declared")


def test_rclpy_in_tests_is_an_info_and_what_runs_them_is_not() -> None:
    text = "import launch\nimport ament_index_python\nimport launch_testing\nimport rclpy\n"
    (finding,) = found("DEP102", declared("launch_testing_ros", tag="test_depend"), test__test_a_DOT_py=text)
    assert finding.message.startswith("`launch` and `rclpy` are imported by tests and not declared: they come with")


@pytest.mark.parametrize(("user", "count"), [("from helper import a\n", 1), ("import os\n", 0)])
def test_a_file_beside_launch_files_counts_where_one_imports_it(user: str, count: int) -> None:
    text = f"{user}\n\ndef generate_launch_description():\n    pass\n"
    files = {"launch__helper_DOT_py": "import cv2\n", "launch__a_DOT_launch_DOT_py": text}
    assert len(found("DEP103", declared("ros2launch"), **files)) == count
