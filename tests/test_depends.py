"""What a package uses against what it declares: where to speak, and the many places where to keep quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.finding import Safety
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
ROS1 = '<build_type condition="$ROS_VERSION == 1">catkin</build_type>\n    <build_type'


def said(code: str, files: dict[str, str | None]) -> list[str]:
    """Return the names in backticks that a rule's findings begin with: the dependency each is about."""
    found = lint_files(existing_files({**PYTHON, **files}), [code]).findings
    return [finding.message.split("`")[1] for finding in found]


def imports(text: str, body: str = "", path: str = "my_pkg/node.py") -> list[str]:
    return said("DEP101", {path: text, "package.xml": manifest(body)})


@pytest.mark.parametrize(
    "text",
    [
        "import os, json\nfrom pathlib import Path\n",
        "try:\n    import cv2\nexcept ImportError:\n    cv2 = None\n",
        "try:\n    import cv2\nexcept (ModuleNotFoundError, OSError):\n    import numpy\n",
        "try:\n    import cv2\nexcept:\n    pass\n",
        "import contextlib\nwith contextlib.suppress(ImportError):\n    import cv2\n",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import cv2\n",
        "import sys\nif sys.platform == 'win32':\n    import serial\nelse:\n    import os\n",
        "import platform\nif platform.machine() == 'aarch64':\n    import serial\nelse:\n    import numpy\n",
        "from . import cv2\nfrom .numpy import x\n",
        "import my_pkg.cv2\n",
        "import beside\n",
        "import no_such_library\n",
    ],
)
def test_imports_that_need_no_declaration(text: str) -> None:
    assert (
        said("DEP101", {"my_pkg/node.py": text, "my_pkg/beside.py": "", "my_pkg/vendored/yaml/__init__.py": ""}) == []
    )


def test_a_lazy_import_is_needed_as_any_other() -> None:
    assert imports("def run():\n    import cv2\n    return cv2\n") == ["python3-opencv"]


def test_what_linux_imports_is_needed() -> None:
    text = "import sys\nif sys.platform == 'win32':\n    import serial\nelse:\n    import numpy\n"
    assert imports(text) == ["python3-numpy"]


def test_a_vendored_copy_is_the_packages_own() -> None:
    assert said("DEP101", {"my_pkg/node.py": "import yaml\n", "my_pkg/vendor/yaml/__init__.py": ""}) == []


def test_one_finding_for_each_dependency() -> None:
    text = "import cv2\nfrom geometry_msgs.msg import Twist\n"
    assert said("DEP101", {"my_pkg/a.py": text, "my_pkg/b.py": text}) == ["python3-opencv", "geometry_msgs"]


@pytest.mark.parametrize("tag", ["depend", "exec_depend", "build_depend", "test_depend"])
def test_a_dependency_under_any_tag_is_declared(tag: str) -> None:
    assert imports("import rclpy\n", f"  <{tag}>rclpy</{tag}>\n") == []


def test_a_dependency_under_a_condition_is_declared() -> None:
    assert imports("import rclpy\n", '  <depend condition="$ROS_DISTRO == humble">rclpy</depend>\n') == []


@pytest.mark.parametrize("key", ["python3-opencv", "libopencv-dev", "python-opencv-contrib-pip"])
def test_any_key_that_brings_the_module_will_do(key: str) -> None:
    assert imports("import cv2\n", f"  <exec_depend>{key}</exec_depend>\n") == []


def test_a_key_that_is_called_like_the_module_will_do() -> None:
    assert imports("import simple_pid\n", "  <exec_depend>python3-simple-pid</exec_depend>\n") == []


def test_interfaces_are_a_ros_package_even_if_nobody_knows_it() -> None:
    assert imports("from acme_msgs.msg import Gripper\n") == ["acme_msgs"]
    assert imports("from acme.msg import helper\n") == []


@pytest.mark.parametrize("path", ["test/test_a.py", "my_pkg/test/helper.py", "docs/conf.py", "scripts/once.py"])
def test_what_is_not_installed_does_not_count(path: str) -> None:
    files = {**PYTHON, path: PYTHON.get(path, "") + "import cv2\n"}
    assert said("DEP101", files) == []


def test_what_setup_py_imports_is_needed_to_build() -> None:
    setup = PYTHON["setup.py"] + "import cv2\nfrom catkin_pkg.python_setup import x\n"
    files = {**PYTHON, "setup.py": setup}
    (finding,) = lint_files(files, ["DEP101"]).findings
    assert "<build_depend>python3-opencv</build_depend>" in finding.message
    cmake = {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": CMAKE}
    assert lint_files({**files, **cmake}, ["DEP101"]).findings == ()


def test_a_package_may_be_called_like_a_test() -> None:
    assert said("DEP101", {"my_test_utils/__init__.py": "import cv2\n"}) == ["python3-opencv"]


def test_ros_1_packages_are_left_alone() -> None:
    only = manifest(build_type="catkin")
    both = manifest().replace("<build_type", ROS1)
    assert said("DEP101", {"package.xml": only, "my_pkg/a.py": "import rclpy\n"}) == []
    assert said("DEP101", {"package.xml": both, "my_pkg/a.py": "import rclpy\n"}) == ["rclpy"]


def test_scripts_of_cmake_packages_count_where_they_are_installed() -> None:
    install = CMAKE.replace(
        "ament_package()", "install(PROGRAMS scripts/run.py DESTINATION lib/my_pkg)\nament_package()"
    )
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": install}
    files |= {"scripts/run.py": "#!/usr/bin/env python3\nimport rclpy\n", "scripts/tool.py": "import cv2\n"}
    assert said("DEP101", files) == ["rclpy"]
    shared = {**files, "CMakeLists.txt": install.replace("lib/my_pkg", "share/my_pkg/scripts")}
    assert said("DEP101", shared) == ["rclpy"]
    assert said("DEP101", {**shared, "cmake/run.cmake": "add_test(NAME a COMMAND run.py)\n"}) == []
    assert said("DEP101", {**shared, "CMakeLists.txt": shared["CMakeLists.txt"].replace("PROGRAMS", "FILES")}) == []


def test_what_a_superbuild_builds_need_not_be_declared() -> None:
    own = "ExternalProject_Add(own SOURCE_DIR ${PROJECT_SOURCE_DIR} CMAKE_ARGS -DUSE_SUPERBUILD=OFF)\n"
    start = 'option(USE_SUPERBUILD "" ON)\nif(USE_SUPERBUILD)\n  {}  return()\nendif()\nproject(my_pkg)'
    lines = "add_executable(node src/node.cpp)\nament_package()"
    files: dict[str, str | None] = {**dict.fromkeys(PYTHON), "package.xml": manifest(build_type="ament_cmake")}
    files["src/node.cpp"] = "#include <gpiod.hpp>\nint main() {return 0;}\n"
    for more, expected in (("", ["libgpiod-dev"]), ("ExternalProject_Add(libgpiod URL x)\n  ", [])):
        text = CMAKE.replace("project(my_pkg)", start.format(own + more)).replace("ament_package()", lines)
        assert said("DEP105", {**files, "CMakeLists.txt": text}) == expected


def test_a_script_without_a_suffix_is_python_by_its_first_line() -> None:
    install = CMAKE.replace("ament_package()", "install(PROGRAMS run DESTINATION lib/my_pkg)\nament_package()")
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": install}
    assert said("DEP101", {**files, "run": "#!/usr/bin/env python3\nimport rclpy\n"}) == ["rclpy"]
    assert said("DEP101", {**files, "run": "#!/bin/sh\nimport rclpy\n"}) == []


def test_packages_around_are_known() -> None:
    around = {f"b/{path}": text for path, text in PYTHON.items()}
    around["b/package.xml"] = manifest(name="acme_driver")
    files = {f"a/{path}": text for path, text in PYTHON.items()} | around | {"a/my_pkg/n.py": "import acme_driver.x\n"}
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings] == ["acme_driver"]


def test_a_metapackage_stands_for_what_it_names() -> None:
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files["a/package.xml"] = manifest("  <exec_depend>acme_all</exec_depend>\n")
    files["a/my_pkg/n.py"] = "import rclpy, cv2\n"
    files["b/package.xml"] = manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_cmake", "acme_all")
    files["b/CMakeLists.txt"] = CMAKE
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings] == ["python3-opencv"]
    files["b/src/node.cpp"] = "int main() {}\n"
    assert {f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings} == {"python3-opencv", "rclpy"}


def test_a_metapackage_that_everybody_knows_stands_for_what_it_names() -> None:
    text = "<launch><node pkg='nav2_amcl' exec='amcl'/><node pkg='controller_manager' exec='x'/></launch>\n"
    body = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in ("navigation2", "ros2_control", "ros2launch"))
    assert said("DEP103", {"launch/a.launch.xml": text, "package.xml": manifest(body)}) == []


def in_tests(body: str, files: dict[str, str | None]) -> list[str]:
    return said("DEP102", {"package.xml": manifest(body), **files})


def test_tests_ask_for_test_dependencies() -> None:
    files: dict[str, str | None] = {"test/test_a.py": "import pytest\nimport numpy\n"}
    assert in_tests("", files) == ["python3-pytest", "python3-numpy"]
    assert in_tests("  <depend>python3-numpy</depend>\n  <test_depend>python3-pytest</test_depend>\n", files) == []


@pytest.mark.parametrize(
    "declared, text",
    [
        ("launch_testing", "import launch\nimport launch_testing\nimport pytest\n"),
        ("launch_testing_ament_cmake", "import launch\nimport launch_testing.actions\nimport ament_index_python\n"),
        ("launch_testing_ros", "import launch_ros\nimport launch_testing\nimport rclpy\n"),
        ("ros_testing", "import launch_ros\nimport launch_testing_ros\n"),
        ("ament_cmake_pytest", "import pytest\n"),
        ("ament_lint_common", "from ament_flake8.main import main\nfrom ament_copyright.main import main\n"),
    ],
)
def test_what_stands_for_others_in_tests(declared: str, text: str) -> None:
    body = f"  <test_depend>{declared}</test_depend>\n"
    found = lint_files({**PYTHON, "package.xml": manifest(body), "test/test_a.py": text}, ["DEP102"]).findings
    assert {finding.severity.value for finding in found} <= {"info"}
    assert all(f"with `{declared}` today" in finding.message for finding in found)
    assert not any("`python3-pytest`" in finding.message for finding in found)


def test_templates_of_tests_are_read_where_cmake_fills_them() -> None:
    test = "import launch\nWHAT = '@NAME@'\nHOW = @HOW@\n"
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(build_type="ament_cmake"), "test/test_a.py.in": test}
    configure = "configure_file(test/test_a.py.in test_a.py)\nament_package()"
    assert said("DEP102", {**files, "CMakeLists.txt": CMAKE.replace("ament_package()", configure)}) == ["launch"]
    assert said("DEP102", {**files, "CMakeLists.txt": CMAKE}) == []


def test_one_test_dependency_may_bring_the_others() -> None:
    files: dict[str, str | None] = {"test/test_a.py": "import launch\nimport launch_testing\nimport pytest\n"}
    assert in_tests("", files) == ["launch_testing"]


def test_what_is_imported_when_it_runs_is_said_once() -> None:
    assert in_tests("", {"test/test_a.py": "import cv2\n", "my_pkg/a.py": "import cv2\n"}) == []


def test_helpers_among_the_tests_that_nothing_runs_do_not_count() -> None:
    assert in_tests("", {"test/record_bag.py": "import cv2\n"}) == []


LAUNCH = "  <exec_depend>ros2launch</exec_depend>\n"


def launches(text: str, body: str = LAUNCH, path: str = "launch/a.launch.xml") -> list[str]:
    return said("DEP103", {path: text, "package.xml": manifest(body)})


def xml(inside: str) -> str:
    return f"<launch>{inside}</launch>"


def test_launch_files_name_packages() -> None:
    text = xml('<node pkg="a" exec="x"/><include file="$(find-pkg-share b)/x"/><executable cmd="xacro x"/>')
    assert launches(text) == ["a", "b", "xacro"]
    body = LAUNCH + "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in ("a", "b", "xacro"))
    assert launches(text, body) == []


@pytest.mark.parametrize(
    "inside",
    [
        '<node pkg="my_pkg" exec="x"/>',
        '<node pkg="$(var robot)_bringup" exec="x"/>',
        '<!-- <node pkg="old" exec="x"/> -->',
        '<include file="$(find-pkg-share $(var p))/x"/>',
        '<include file="$(dirname)/x.launch.xml"/>',
        '<node pkg="ros1" type="x" name="y"/>',
    ],
)
def test_launch_files_that_need_nothing(inside: str) -> None:
    assert launches(xml(inside)) == []


IMPORTS = "import launch\nimport launch_ros\nimport ament_index_python\ndef generate_launch_description(): pass\n"


@pytest.mark.parametrize("declared", ["ros2launch", "launch_ros"])
def test_what_stands_for_launch(declared: str) -> None:
    assert launches(IMPORTS, f"  <exec_depend>{declared}</exec_depend>\n", "launch/a.launch.py") == []


def test_launch_itself_is_asked_for_once_and_mildly() -> None:
    files = {**PYTHON, "launch/a.launch.py": IMPORTS, "launch/b.launch.py": IMPORTS}
    (finding,) = lint_files(files, ["DEP103"]).findings
    assert finding.severity.value == "info"
    assert "ros2launch" in finding.message


def test_a_package_that_is_expected_to_be_missing_is_optional() -> None:
    text = (
        "from ament_index_python.packages import PackageNotFoundError, get_package_share_directory\n"
        "try:\n    get_package_share_directory('nice_to_have')\nexcept PackageNotFoundError:\n    pass\n"
    )
    assert launches(text, LAUNCH, "launch/a.launch.py") == []


def test_launch_files_of_tests_ask_for_test_dependencies() -> None:
    files: dict[str, str | None] = {**PYTHON, "test/a.launch.xml": xml('<node pkg="joy" exec="x"/>')}
    (finding,) = lint_files(existing_files(files), ["DEP103"]).findings
    assert "<test_depend>joy</test_depend>" in finding.message


def test_code_that_describes_nodes_is_asked_mildly() -> None:
    code = "def make(Writer, name):\n    return [Writer.Node(package='nav2_amcl', executable='amcl'), {}]\n"
    for other in ("Writer.Node(package=name, executable='x')", "Box(package='b', executable='c')", "Node(package='d')"):
        files = {**PYTHON, "my_pkg/generator.py": code.format(other)}
        assert [f.severity.value for f in lint_files(files, ["DEP103"]).findings] == ["info"]
    body = "  <exec_depend>nav2_amcl</exec_depend>\n"
    assert said("DEP103", {"my_pkg/generator.py": code.format(0), "package.xml": manifest(body)}) == []


def test_nodes_that_code_describes_are_one_info() -> None:
    node = "    Writer.Node(package='{}', executable='x')\n"
    code = "def make(Writer):\n" + "".join(map(node.format, ("tf2_ros", "my_robot_of_none", "nav2_amcl", "tf2_ros")))
    (found,) = lint_files(existing_files({**PYTHON, "my_pkg/generator.py": code}), ["DEP103"]).findings
    assert found.message.startswith("`my_robot_of_none`, `nav2_amcl` and `tf2_ros` are not declared, and this code")
    assert [message for _, message in found.related] == ["`nav2_amcl` here", "`tf2_ros` here"]
    assert found.fix is not None
    assert found.fix.title == "declare `nav2_amcl` and `tf2_ros`"


LEVELS = [("nav_example", "info"), ("demo_arm", "info"), ("nav_demo", "info"), ("demo", "warning"), ("arm", "warning")]


@pytest.mark.parametrize("name, level", LEVELS)
def test_launch_files_that_are_examples_are_asked_mildly(name: str, level: str) -> None:
    files = {**PYTHON, f"launch/{name}_launch.xml": xml('<node pkg="joy" exec="x"/>')}
    assert [f.severity.value for f in lint_files(files, ["DEP103"]).findings] == [level]


def test_a_dependency_in_a_comment_was_thought_about() -> None:
    body = LAUNCH + "  <!-- not released yet: <exec_depend>a</exec_depend> -->\n"
    files = {**PYTHON, "launch/a.launch.xml": xml('<node pkg="a" exec="x"/>'), "package.xml": manifest(body)}
    assert [f.severity.value for f in lint_files(files, ["DEP103"]).findings] == ["info"]


@pytest.mark.parametrize("condition, level", [("$ROS_DISTRO == galactic", "info"), ("$ROS_VERSION == 1", "warning")])
def test_a_dependency_for_an_older_distribution_was_thought_about(condition: str, level: str) -> None:
    body = LAUNCH + f'  <exec_depend condition="{condition}">joy</exec_depend>\n'
    files = {**PYTHON, "launch/a.launch.xml": xml('<node pkg="joy" exec="x"/>'), "package.xml": manifest(body)}
    (finding,) = lint_files(files, ["DEP103"]).findings
    assert finding.severity.value == level
    assert finding.message.endswith("widen the condition") is (level == "info")


def test_a_dependency_that_would_close_a_circle_is_not_asked_for() -> None:
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files["a/launch/x.launch.xml"] = xml('<node pkg="b" exec="x"/>')
    files["b/package.xml"] = manifest("  <exec_depend>US</exec_depend>\n", "cmake", "b").replace("US", "my_pkg")
    assert [f.message for f in lint_files(files, ["DEP103"]).findings] == []


def test_a_name_near_one_of_the_workspace_is_written_and_not_declared() -> None:
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files["a/launch/x.launch.xml"] = xml('<node pkg="acme_drivr" exec="x"/>')
    files["b/package.xml"] = manifest("", "cmake", "acme_driver")
    (finding,) = lint_files(files, ["DEP103"]).findings
    assert "did you mean `acme_driver`?" in finding.message
    assert finding.fix is not None
    assert (finding.fix.safety, [edit.text for edit in finding.fix.operations]) == (Safety.UNSAFE, ["acme_driver"])


@pytest.mark.parametrize("name, meant", [("rclpi", ["rclpy"]), ("joi", []), ("qclcpp", []), ("clcpp", [])])
def test_a_misspelt_name_of_few_letters_may_mean_anything(name: str, meant: list[str]) -> None:
    files = {**PYTHON, "package.xml": manifest(f"  <exec_depend>{name}</exec_depend>\n")}
    found = [finding.message for finding in lint_files(files, ["DEP001"]).findings]
    assert [word for word in meant if f"did you mean `{word}`?" in found[0]] == meant
    assert len(found) == len(meant)


SCRIPT = PYTHON["setup.py"].replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)


@pytest.mark.parametrize(
    ("nodes", "meant"),
    [
        ('<node pkg="acme_robot" exec="talker"/>', ["did you mean `my_pkg`?"]),
        ('<node pkg="acme_robot" exec="talker"/>\n  <node pkg="acme_robot" exec="other"/>', []),
        ('<include file="$(find-pkg-share acme_robot)/a.launch.xml"/>', []),
        ('<node pkg="tf2_ros" exec="talker"/>', []),
    ],
)
def test_a_package_that_has_what_is_started_of_an_unknown_one_is_meant(nodes: str, meant: list[str]) -> None:
    files = {**PYTHON, "setup.py": SCRIPT, "my_pkg/talker.py": "", "launch/a.launch.xml": xml(nodes)}
    found = [each.message.rpartition(": ")[2] for each in lint_files(existing_files(files), ["DEP103"]).findings]
    assert [each for each in found if "mean" in each] == meant
    assert len(found) == 1


def starts(inside: str, **more: str | None) -> list[str]:
    files = {**PYTHON, "setup.py": SCRIPT, "my_pkg/talker.py": "", "launch/a.launch.xml": xml(inside), **more}
    return [f.location.path for f in lint_files(existing_files(files), ["LCH002"]).findings]


def test_executables_of_the_own_package() -> None:
    assert starts('<node pkg="my_pkg" exec="talker"/>') == []
    assert starts('<node pkg="my_pkg" exec="listener"/>') == ["launch/a.launch.xml"]


@pytest.mark.parametrize(
    "inside",
    [
        '<node pkg="elsewhere" exec="listener"/>',
        '<node pkg="my_pkg" exec="$(var which)"/>',
        '<node pkg="my_pkg" type="listener" name="x"/>',
    ],
)
def test_executables_that_nobody_can_tell(inside: str) -> None:
    assert starts(inside) == []


def test_executables_that_are_computed_keep_the_rule_quiet() -> None:
    computed = SCRIPT.replace("['talker = my_pkg.talker:main']", "[line for line in open('/etc/nodes')]")
    assert starts('<node pkg="my_pkg" exec="listener"/>', **{"setup.py": computed}) == []


@pytest.mark.parametrize(
    "text, fires",
    [
        ("from .base import generate_launch_description\n", False),
        ("from base import *\n", False),
        ("generate_launch_description = make('x')\n", False),
        ("def generate_test_description():\n    pass\n", False),
        ("def main():\n    pass\n\n\nif __name__ == '__main__':\n    main()\n", False),
        ("def generate_launch_descripton():\n    pass\n", True),
        ("", True),
    ],
)
def test_launch_files_that_launch_can_load(text: str, fires: bool) -> None:
    files = {**PYTHON, "launch/a.launch.py": text, "launch/helpers.py": "", "test/b_launch.py": ""}
    assert bool(lint_files(files, ["LCH001"]).findings) is fires


def names(body: str, code: str = "DEP001", build_type: str = "ament_python") -> list[str]:
    """Return the names that a rule about names complains of, and what it offers in their place."""
    files = {"package.xml": manifest(body, build_type), "setup.py": "", "CMakeLists.txt": ""}
    found = lint_files(files, [code]).findings
    return [" → ".join([f.message.split("`")[1], *([f.fix.title.split("`")[1]] if f.fix else [])]) for f in found]


def line(name: str, tag: str = "exec_depend") -> str:
    return f"  <{tag}>{name}</{tag}>\n"


@pytest.mark.parametrize(
    "name, meant",
    [
        ("opencv-python", "python3-opencv"),
        ("pyserial", "python3-serial"),
        ("pytest", "python3-pytest"),
        ("Eigen3", "eigen"),
        ("OpenCV", "libopencv-dev"),
        ("std_svrs", "std_srvs"),
        ("rclcpp_component", "rclcpp_components"),
    ],
)
def test_names_from_elsewhere(name: str, meant: str) -> None:
    assert names(line(name)) == [f"{name} → {meant}"]


def test_what_comes_with_python_needs_no_dependency() -> None:
    assert names(line("python3-threading")) == ["python3-threading"]


@pytest.mark.parametrize(
    "name",
    ["rclpy", "python3-numpy", "my_companys_driver", "ament_python", "rospy", "tf", "gz-plugin9", "libfreenect2-dev"],
)
def test_names_that_are_right_or_that_nobody_can_tell(name: str) -> None:
    assert names(line(name)) == []


def test_a_cpp_package_may_have_a_private_dependency_of_a_name_on_pypi() -> None:
    assert names(line("serial", "depend"), build_type="ament_cmake") == []


def test_docs_have_names_of_their_own() -> None:
    assert names(line("lark", "doc_depend")) == []


def test_a_package_that_its_family_renamed() -> None:
    files = {f"{name}/package.xml": manifest("", "cmake", name) for name in ("acme_arm", "acme_hand", "acme_eye")}
    files["acme_base/package.xml"] = manifest(line("arm"), "cmake", "acme_base")
    assert ["acme_arm" in f.message for f in lint_files(files, ["DEP001"]).findings] == [True]


def test_ros_1_names() -> None:
    assert names(line("rospy") + line("roscpp", "depend"), "DEP203") == ["rospy", "roscpp"]
    assert names('  <exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>\n', "DEP203") == []
    assert names(line("roscpp"), "DEP203", "catkin") == []


def test_pip_keys_of_the_targets() -> None:
    assert names(line("python3-ultralytics-pip") + line("python3-numpy"), "DEP002") == ["python3-ultralytics-pip"]


def cmake(*lines: str) -> str:
    return CMAKE.replace("ament_package()", "\n".join([*lines, "ament_package()"]))


def built(code: str, text: str, body: str = "", **more: str | None) -> list[str]:
    """Return the dependencies that a rule names in an ament_cmake package."""
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": text, **more}
    return said(code, files)


@pytest.mark.parametrize(
    "lines",
    [
        ["find_package(rclcpp QUIET)"],
        ["find_package(rclcpp)"],
        ["if(WIN32)", "find_package(rclcpp REQUIRED)", "endif()"],
        ["find_package(Threads REQUIRED)", "find_package(Python3 REQUIRED)", "find_package(PkgConfig REQUIRED)"],
        ["find_package(ament_cmake_python REQUIRED)"],
        ["find_package(nobody_knows_this REQUIRED)"],
        ["find_package(${WHICH} REQUIRED)"],
    ],
)
def test_what_cmake_looks_for_without_need(lines: list[str]) -> None:
    assert built("DEP104", cmake(*lines)) == []


@pytest.mark.parametrize(
    "lines, name",
    [
        (["find_package(rclcpp REQUIRED)"], "rclcpp"),
        (["set(NEEDS rclcpp)", "foreach(need ${NEEDS})", "find_package(${need} REQUIRED)", "endforeach()"], "rclcpp"),
        (["find_package(rclcpp)", "add_library(a a.cpp)", "target_link_libraries(a rclcpp::rclcpp)"], "rclcpp"),
        (["find_package(rclcpp)", "ament_export_dependencies(rclcpp)"], "rclcpp"),
        (["find_package(Eigen3 REQUIRED)"], "Eigen3"),
    ],
)
def test_what_cmake_needs(lines: list[str], name: str) -> None:
    assert built("DEP104", cmake(*lines)) == [name]


def test_any_key_of_a_library_will_do() -> None:
    text = cmake("find_package(Boost REQUIRED)", "find_package(OpenCV REQUIRED)", "find_package(Eigen3 REQUIRED)")
    body = line("libboost-filesystem-dev", "depend") + line("cv_bridge", "depend") + line("eigen", "build_depend")
    assert built("DEP104", text, body) == []


@pytest.mark.parametrize("key", ["octomap", "liboctomap-dev", "octomap_vendor"])
def test_a_library_may_be_a_package_and_a_key(key: str) -> None:
    text = cmake("find_package(octomap REQUIRED)", "add_executable(node src/node.cpp)")
    include: dict[str, str | None] = {"src/node.cpp": "#include <octomap/octomap.h>\n"}
    assert built("DEP104", text, line(key, "depend"), **include) == []
    assert built("DEP105", text, line(key, "depend"), **include) == []


def test_what_another_dependency_brings_is_milder() -> None:
    def levels(text: str, body: str) -> list[str]:
        files = {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": text}
        return [f.severity.value for f in lint_files(files, ["DEP104"]).findings]

    assert levels(cmake("find_package(std_msgs REQUIRED)"), "") == ["warning"]
    assert levels(cmake("find_package(std_msgs REQUIRED)"), line("sensor_msgs", "depend")) == ["info"]
    assert levels(cmake("find_package(std_msgs REQUIRED)"), line("who_knows_what", "depend")) == ["info"]
    assert levels(cmake("if(BUILD_TESTING)", "find_package(std_msgs REQUIRED)", "endif()"), "") == ["warning"]


NODE = cmake("add_executable(node src/node.cpp)")


@pytest.mark.parametrize(
    "text, found",
    [
        ("#include <rclcpp/rclcpp.hpp>\n", ["rclcpp"]),
        ('#include "geometry_msgs/msg/pose.hpp"\n', ["geometry_msgs"]),
        ("#include <opencv2/core.hpp>\n", ["libopencv-dev"]),
        ("#include <yaml-cpp/yaml.h>\n", ["yaml-cpp"]),
        ("#include <vector>\n#include <sys/types.h>\n", []),
        ('#include "my_pkg/node.hpp"\n#include "detail/x.hpp"\n', []),
        ("#ifdef WITH_X\n#include <rclcpp/rclcpp.hpp>\n#endif\n", []),
        ("// #include <rclcpp/rclcpp.hpp>\n", []),
        ("#include <moveit/robot_model/robot_model.h>\n", []),
    ],
)
def test_includes(text: str, found: list[str]) -> None:
    assert built("DEP105", NODE, **{"src/node.cpp": text, "src/detail/x.hpp": ""}) == found


def test_files_that_nothing_compiles_include_what_they_like() -> None:
    text = "#include <rclcpp/rclcpp.hpp>\n"
    assert built("DEP105", NODE, **{"src/node.cpp": "", "src/old.cpp": text}) == []
    assert built("DEP105", NODE, **{"src/node.cpp": '#include "old.hpp"\n', "src/old.hpp": text}) == ["rclcpp"]
    assert built("DEP105", NODE, **{"src/node.cpp": "", "include/my_pkg/public.hpp": text}) == ["rclcpp"]


@pytest.mark.parametrize(
    "folder, found",
    [
        ("${CMAKE_CURRENT_SOURCE_DIR}/../rclcpp/include", []),
        ("${CMAKE_CURRENT_SOURCE_DIR}/../other/include", ["rclcpp"]),
        ("include", ["rclcpp"]),
    ],
)
def test_a_neighbour_whose_folder_cmake_names_needs_no_package(folder: str, found: list[str]) -> None:
    text = cmake("add_executable(node src/node.cpp)", f"include_directories({folder})")
    assert built("DEP105", text, **{"src/node.cpp": "#include <rclcpp/rclcpp.hpp>\n"}) == found


def including(text: str, cmake_lines: str = NODE, depends: str = "", **files: str) -> list[tuple[str, str]]:
    """Return level and consequence of what DEP105 says of a header for others that includes something."""
    tree = {
        "package.xml": manifest(depends, "ament_cmake"),
        "CMakeLists.txt": cmake_lines,
        "src/node.cpp": "int main() {}\n",
        "include/my_pkg/public.hpp": text,
    }
    found = lint_files({**existing_files(BACKDROPS["ament_cmake"]), **tree, **files}, ["DEP105"]).findings
    return [(each.severity.value, each.message.partition(": ")[2].partition(";")[0]) for each in found]


INSTALLED = "install(DIRECTORY include/ DESTINATION include)"
ENDS = 'the build ends with "No such file or directory" where nothing else brings it'
STOPS = "CMake, which requires it, stops where nothing else brings it"


@pytest.mark.parametrize(
    ("lines", "source", "found"),
    [
        ((INSTALLED,), "", [("info", ENDS)]),
        (("add_executable(node src/node.cpp)", INSTALLED), "", [("info", ENDS)]),
        (("add_executable(node src/node.cpp)", INSTALLED), '#include "my_pkg/public.hpp"\n', [("warning", ENDS)]),
        (("add_executable(node src/node.cpp)",), "", [("info", ENDS)]),
    ],
)
def test_a_header_that_is_not_compiled_beside_others(lines: tuple[str, ...], source: str, found: list[object]) -> None:
    assert including("#include <rclcpp/rclcpp.hpp>\n", cmake(*lines), **{"src/node.cpp": source}) == found


@pytest.mark.parametrize(("used", "level"), [("my_pkg/public.hpp", "warning"), ("my_pkg/other.hpp", "info")])
def test_a_header_for_others_that_a_package_here_includes(used: str, level: str) -> None:
    """A package that only depends on this one, and includes something else of it, does not meet the header."""
    other = CMAKE.replace("my_pkg", "other").replace("ament_package()", "add_executable(o src/o.cpp)\nament_package()")
    tree = {
        "my_pkg/package.xml": manifest("", "ament_cmake"),
        "my_pkg/CMakeLists.txt": cmake(INSTALLED, "ament_export_include_directories(include)"),
        "my_pkg/include/my_pkg/public.hpp": "#include <rclcpp/rclcpp.hpp>\n",
        "other/package.xml": manifest("  <depend>NEED</depend>\n", "ament_cmake", "other").replace("NEED", "my_pkg"),
        "other/CMakeLists.txt": other,
        "other/src/o.cpp": f"#include <{used}>\nint main() {{}}\n",
    }
    found = lint_files(tree, ["DEP105"]).findings
    assert [each.severity.value for each in found if each.location.path.startswith("my_pkg/")] == [level]


def test_a_source_among_the_headers_is_none() -> None:
    assert including("", cmake(INSTALLED), **{"include/my_pkg/old.cpp": "#include <rclcpp/rclcpp.hpp>\n"}) == []


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("tins/tins.h", "pkg_check_modules(T REQUIRED libtins>=4)", STOPS),
        ("tins/tins.h", "pkg_search_module(T libtins)", ENDS),
        ("tins/tins.h", "if(WITH_TINS)\n  pkg_check_modules(T REQUIRED libtins)\nendif()", ENDS),
        ("tins/tins.h", "pkg_check_modules(T REQUIRED libiio)", ENDS),
        ("acme_msgs/msg/a.hpp", "find_package(acme_msgs REQUIRED)", STOPS),
        ("acme_msgs/msg/a.hpp", "find_package(acme_msgs)", ENDS),
        ("acme_msgs/msg/a.hpp", "if(WITH_ACME)\n  find_package(acme_msgs REQUIRED)\nendif()", ENDS),
    ],
)
def test_cmake_stops_before_the_compiler_does(text: str, line: str, says: str) -> None:
    lines, include = cmake(line, "add_executable(node src/node.cpp)"), f"#include <{text}>\n"
    other = {"other/package.xml": manifest("  <depend>acme_msgs</depend>\n", "ament_cmake", "other")}
    other["other/CMakeLists.txt"] = CMAKE.replace("my_pkg", "other")
    files = {f"my_pkg/{path}": each for path, each in existing_files(BACKDROPS["ament_cmake"]).items()}
    files |= {"my_pkg/CMakeLists.txt": lines, "my_pkg/src/node.cpp": include, **other}
    assert [f.message.partition(": ")[2].partition(";")[0] for f in lint_files(files, ["DEP105"]).findings] == [says]


def test_what_cmake_fetches_need_not_be_declared() -> None:
    fetched = cmake("FetchContent_Declare(yaml-cpp GIT_REPOSITORY x)", "add_executable(node src/node.cpp)")
    text = "#include <yaml-cpp/yaml.h>\n"
    assert built("DEP105", fetched, **{"src/node.cpp": text}) == []
    assert built("DEP105", fetched.replace("yaml-cpp", "toml"), **{"src/node.cpp": text}) == ["yaml-cpp"]


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("kdl_parser_py", ("unsafe", ", which only lyrical and rolling have")),
        ("rslidar_sdk", ("unsafe", ", which only jazzy has")),
        ("gazebo_ros", ("safe", "")),
        ("joy", ("safe", "")),
    ],
)
def test_a_package_that_the_oldest_distribution_lacks(name: str, says: tuple[str, str]) -> None:
    files = {**existing_files(BACKDROPS["ament_python"])}
    files["launch/a.launch.xml"] = f'<launch>\n  <node pkg="{name}" exec="a"/>\n</launch>\n'
    (finding,) = lint_files(files, ["DEP103"]).findings
    assert finding.fix is not None
    assert (finding.fix.safety.value, finding.message.partition("_depend>")[2].partition(">")[2]) == says


@pytest.mark.parametrize("comment", ["<!-- depend>rclcpp</depend -->", "<!-- <depend>rclcpp</depend> -->"])
def test_a_dependency_in_a_comment_is_left_out_on_purpose(comment: str) -> None:
    source = {"src/node.cpp": "#include <rclcpp/rclcpp.hpp>\n"}
    assert including("", depends=f"  {comment}\n", **source) == [("info", ENDS)]
    assert including("", depends="  <!-- independ>rclcpp -->\n", **source) == [("warning", ENDS)]


def test_an_include_that_find_package_names_is_said_once() -> None:
    text = cmake("find_package(rclcpp REQUIRED)", "add_executable(node src/node.cpp)")
    source = "#include <rclcpp/rclcpp.hpp>\n"
    assert built("DEP105", text, **{"src/node.cpp": source}) == []
    assert built("DEP104", text, **{"src/node.cpp": source}) == ["rclcpp"]


def test_headers_of_packages_around_are_known_by_their_folder() -> None:
    files = {
        "core/package.xml": manifest("", "ament_cmake", "acme_core"),
        "core/CMakeLists.txt": CMAKE.replace("my_pkg", "acme_core"),
        "core/include/acme/core/core.hpp": "",
        "app/package.xml": manifest("", "ament_cmake"),
        "app/CMakeLists.txt": NODE,
        "app/include/acme/app/app.hpp": "",
        "app/src/node.cpp": "#include <acme/core/core.hpp>\n#include <acme/app/app.hpp>\n",
    }
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP105"]).findings] == ["acme_core"]


def test_types_of_other_packages() -> None:
    text = "geometry_msgs/Pose pose\nOwn own\nmy_pkg/Own too\nstring name\n"
    generate = cmake('rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg" DEPENDENCIES geometry_msgs)')
    files = {"msg/A.msg": text, "msg/Own.msg": ""}
    assert built("DEP108", generate, **files) == ["geometry_msgs"]
    assert built("DEP108", generate, line("geometry_msgs", "depend"), **files) == []
    found = cmake("find_package(geometry_msgs REQUIRED)", 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg")')
    assert built("DEP104", found, **files) == []


def test_of_a_leftover_of_ros_1_that_alone_is_said() -> None:
    text = "import numpy\nimport rospy\nimport rospy.names\nimport cv2\n"
    files = {**PYTHON, "my_pkg/old.py": text, "my_pkg/new.py": "import cv2\n"}
    old, new = sorted(lint_files(files, ["DEP101"]).findings, key=lambda finding: finding.message, reverse=True)
    assert (old.location.path, old.location.line, old.severity.value) == ("my_pkg/old.py", 2, "warning")
    assert "port it to rclpy" in old.message
    assert [place.path for place, _ in new.related] == []
    assert new.location.path == "my_pkg/new.py"


@pytest.mark.parametrize(
    "text", ["try:\n    import rospy\nexcept ImportError:\n    rospy = None\n", "def old():\n    import rospy\n"]
)
def test_an_optional_import_of_ros_1_is_no_leftover(text: str) -> None:
    assert imports(text + "import cv2\n") == ["python3-opencv"]


def test_a_package_is_no_dependency_of_itself_under_its_old_name() -> None:
    old = {path.replace("my_pkg", "old_name"): text.replace("my_pkg", "old_name") for path, text in PYTHON.items()}
    text = '<launch><node pkg="old_name" exec="x"/></launch>\n'
    files = {**old, "package.xml": manifest(LAUNCH, name="new_name"), "launch/a.launch.xml": text}
    assert lint_files(files, ["DEP103"]).findings == ()


def test_a_package_that_declares_rospy_is_for_both_worlds() -> None:
    body = '  <exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>\n'
    assert imports("import rospy\nimport cv2\n", body) == []


@pytest.mark.parametrize(
    "path, text, code",
    [
        ("my_pkg/test_a.py", "import cv2\n\n\ndef test_x():\n    pass\n", "DEP102"),
        ("my_pkg/a_test.py", "import cv2\nimport unittest\n", "DEP102"),
        ("my_pkg/a_tests.py", "import cv2\nimport pytest\n", "DEP102"),
        ("my_pkg/test_a.py", "import cv2\n\n\ndef check_x():\n    pass\n", "DEP101"),
        ("my_pkg/testing.py", "import cv2\n\n\ndef test_x():\n    pass\n", "DEP101"),
        ("my_pkg/a.py", "import cv2\n\n\ndef test_x():\n    pass\n", "DEP101"),
    ],
)
def test_a_module_of_tests_needs_what_tests_need(path: str, text: str, code: str) -> None:
    found = lint_files(existing_files({**PYTHON, path: text}), ["DEP101", "DEP102"]).findings
    assert [f.code for f in found if "cv2" in f.message or "opencv" in f.message] == [code]


@pytest.mark.parametrize(
    "more",
    [
        {"my_pkg/b.py": "from .test_a import test_x\n"},
        {"my_pkg/b.py": "from . import test_a\n"},
        {"my_pkg/b.py": "import my_pkg.test_a\n"},
        {"setup.py": SCRIPT.replace("my_pkg.talker:main", "my_pkg.test_a:test_x")},
        {"setup.py": SCRIPT.replace("['talker = my_pkg.talker:main']", "[line for line in open('/etc/nodes')]")},
    ],
)
def test_a_module_of_tests_that_runs_is_no_test(more: dict[str, str]) -> None:
    files = {**PYTHON, "my_pkg/test_a.py": "import cv2\n\n\ndef test_x():\n    pass\n", **more}
    assert "python3-opencv" in said("DEP101", files)
    assert said("DEP102", {**files, "my_pkg/test_b.py": "from .test_a import x\n\n\ndef test_y():\n    pass\n"}) == []


def prefixed(text: str, path: str = "launch/a.launch.xml", body: str = "") -> list[tuple[str, str]]:
    found = lint_files({**PYTHON, "package.xml": manifest(body), path: text}, ["DEP103"]).findings
    return [(f.message, f.severity.value) for f in found if f.message.startswith("`xterm`")]


NEEDS_XTERM = (
    "`xterm` is not declared, and this launch file starts a node with it: on a clean machine the process does not "
    "start; add <exec_depend>xterm</exec_depend>"
)


@pytest.mark.parametrize(
    "attributes, says",
    [
        ('launch-prefix="xterm -e"', True),
        ('launch-prefix="/usr/bin/xterm"', True),
        ('launch-prefix="xterm -e" if="$(var debug)"', False),
        ('launch-prefix="$(var x) xterm"', False),
        ('launch-prefix="nice xterm"', False),
    ],
)
def test_a_program_before_a_node_must_be_installed(attributes: str, says: bool) -> None:
    found = prefixed(xml(f'<node pkg="my_pkg" exec="a" {attributes}/>'))
    assert found == ([(NEEDS_XTERM, "warning")] if says else [])
    assert prefixed(xml(f'<node pkg="my_pkg" exec="a" {attributes}/>'), body=line("xterm")) == []


@pytest.mark.parametrize(
    "prefix, level",
    [
        ("xterm -e", "warning"),
        ("xterm -e gdb -ex run --args", "info"),
        ("xterm -hold -e /usr/bin/valgrind", "info"),
        ("xterm -e ./gdb.sh", "warning"),
    ],
)
def test_who_watches_a_node_needs_no_declaration(prefix: str, level: str) -> None:
    found = prefixed(xml(f'<node pkg="my_pkg" exec="a" launch-prefix="{prefix}"/>'))
    assert [each for _, each in found] == [level]


def test_what_a_desktop_has_is_said_of_machines_without_one() -> None:
    node = xml('<node pkg="my_pkg" exec="a" launch-prefix="gnome-terminal --"/>')
    found = lint_files({**PYTHON, "package.xml": manifest(""), "launch/a.launch.xml": node}, ["DEP103"]).findings
    told = [each for each in found if "`gnome-terminal`" in each.message]
    assert [(each.severity.value, "unless Ubuntu's desktop is there" in each.message) for each in told] == [
        ("info", True)
    ]


def told_of_xterm(other: str) -> list[str]:
    node = '<node pkg="my_pkg" exec="a" launch-prefix="xterm -e"/>'
    files = {**PYTHON, "package.xml": manifest(""), "launch/a.launch.xml": xml(f"{other}{node}")}
    return [f.severity.value for f in lint_files(files, ["DEP103"]).findings if "`xterm`" in f.message]


@pytest.mark.parametrize(
    "other, level",
    [
        ('<include file="$(find-pkg-share unheard_of_bringup)/launch/b.launch.py"/>', "info"),
        ('<node pkg="unheard_of_bringup" exec="b"/>', "info"),
        ('<arg name="sim" default="false"/><node pkg="unheard_of_bringup" exec="b" if="$(var sim)"/>', "warning"),
        ('<node pkg="turtlesim" exec="turtlesim_node"/>', "warning"),
        ('<node pkg="my_pgk" exec="b"/>', "warning"),
    ],
)
def test_a_program_that_may_come_with_what_the_launch_file_needs(other: str, level: str) -> None:
    assert told_of_xterm(other) == [level]


@pytest.mark.parametrize(
    "arguments, says",
    [
        ("prefix='xterm -e'", True),
        ("prefix=['xterm -e']", True),
        ("prefix=[LaunchConfiguration('x'), ' xterm']", False),
        ("prefix='xterm -e', condition=IfCondition(LaunchConfiguration('x'))", False),
        ("name='xterm'", False),
    ],
)
def test_a_program_before_a_node_in_python(arguments: str, says: bool) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch.conditions import IfCondition\n"
        "from launch.substitutions import LaunchConfiguration\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        f"    return LaunchDescription([Node(package='my_pkg', executable='a', {arguments})])\n"
    )
    assert bool(prefixed(text, "launch/a.launch.py")) is says


def test_a_dependency_for_ros_1_serves_no_code_of_ros_2() -> None:
    text = xml('<node pkg="robot_state_publisher" exec="x"/>')
    for condition, says in (
        ("$ROS_VERSION == 1", ["robot_state_publisher"]),
        ("$ROS_VERSION == 2", []),
        ("$ROS_DISTRO == humble", []),
        ("$ROS_DISTRO == noetic", ["robot_state_publisher"]),
        ("$OURS == 1", []),
    ):
        body = f'  <exec_depend condition="{condition}">robot_state_publisher</exec_depend>\n'
        assert said("DEP103", {"launch/a.launch.xml": text, "package.xml": manifest(body)}) == says


def test_what_a_tool_hands_on_is_there_when_it_runs() -> None:
    assert said("DEP201", {"my_pkg/a.py": "import rclpy\n", "package.xml": manifest(line("rclpy", "test_depend"))}) == [
        "rclpy"
    ]
    body = manifest(line("rclpy", "buildtool_export_depend"))
    assert said("DEP201", {"my_pkg/a.py": "import rclpy\n", "package.xml": body}) == []


def of_cpp(text: str, depends: str = "", cmake: str = "") -> list[tuple[str, str]]:
    """Return what DEP105 says of a package with one source, each with its level."""
    lines = CMAKE.replace("ament_package()", f"{cmake}add_executable(node src/node.cpp)\nament_package()")
    files = {**existing_files(BACKDROPS["ament_cmake"]), "package.xml": manifest(depends, "ament_cmake")}
    found = lint_files({**files, "CMakeLists.txt": lines, "src/node.cpp": text}, ["DEP105"]).findings
    return [(f.message.partition(": ")[0], f.severity.value) for f in found]


@pytest.mark.parametrize(
    "text, says",
    [
        ("nav_msgs::msg::Odometry a;\n", True),
        ("::nav_msgs::srv::GetMap::Request a;\n", True),
        ("std::vector<nav_msgs::action::X> a;\n", True),
        ("// nav_msgs::msg::Odometry a;\n", False),
        ('auto a = "nav_msgs::msg::Odometry";\n', False),
        ("acme::nav_msgs::msg::Odometry a;\n", False),
        ("no_such_msgs::msg::Odometry a;\n", False),
        ("nav_msgs::msg::odometry a;\n", False),
        ("nav_msgs::detail::Odometry a;\n", False),
        ("my_pkg::msg::Status a;\n", False),
    ],
)
def test_a_generated_type_is_a_use_of_its_package(text: str, says: bool) -> None:
    found = of_cpp(text)
    assert bool(found) is says
    if found:
        (what, level) = found[0]
        assert what.startswith("`nav_msgs` is not declared, and `nav_msgs::")
        assert what.endswith("` of it is used")
        assert level == "warning"


def test_a_type_of_what_is_included_found_or_declared_is_told_once() -> None:
    text = "nav_msgs::msg::Odometry a;\n"
    assert len(of_cpp("#include <nav_msgs/msg/odometry.hpp>\n" + text)) == 1
    assert of_cpp(text, cmake="find_package(nav_msgs REQUIRED)\n") == []
    assert of_cpp(text, line("nav_msgs", "depend")) == []
    assert len(of_cpp(text + text)) == 1


@pytest.mark.parametrize(
    ("code", "lines", "source", "key"),
    [
        ("DEP104", "find_package(Eigen3 REQUIRED)", "int main() {}", "eigen"),
        ("DEP105", "add_executable(node src/node.cpp)", "#include <std_msgs/msg/string.hpp>", "std_msgs"),
        ("DEP115", "add_executable(node src/node.cpp)\ntarget_link_libraries(node modbus)", "", "libmodbus-dev"),
    ],
)
def test_what_rosdep_installs_for_another_package_is_there_to_build(
    code: str, lines: str, source: str, key: str
) -> None:
    own = {f"own/{path}": each for path, each in existing_files(BACKDROPS["ament_cmake"]).items()}
    own |= {"own/CMakeLists.txt": cmake(lines), "own/src/node.cpp": f"{source}\n"}
    beside = {each: body.format(key) for each, body in BESIDE.items()}
    released = {**beside, "tracks.yaml": "tracks: {}\n"}
    for others, level in (({}, "warning"), (beside, "info"), (released, "warning")):
        (found,) = lint_files({**own, **others}, [code]).findings
        assert found.severity.value == level


def test_what_lies_in_the_workspace_is_built_only_where_it_is_declared() -> None:
    own = {**{f"own/{each}": body for each, body in PYTHON.items()}, "own/my_pkg/a.py": "import tool.a\n"}
    tool = {f"tool/{each}": body.replace("my_pkg", "tool") for each, body in PYTHON.items()}
    tool = {path.replace("my_pkg", "tool"): text for path, text in tool.items()}
    tool |= {"tool/tool/__init__.py": "", "tool/tool/a.py": "", "tool/resource/tool": ""}
    beside = {each: body.format("tool") for each, body in BESIDE.items()}
    (found,) = lint_files({**own, **tool, **beside}, ["DEP101"]).findings
    assert "--packages-up-to" in found.message
    assert found.severity.value == "warning"


STARTS_JOY = '<launch><node pkg="joy" exec="joy_node"/></launch>\n'
LOOKS_UP = (
    "from ament_index_python.packages import get_package_share_directory\nA = get_package_share_directory('joy')\n"
)
BESIDE = {"beside/package.xml": manifest("  <depend>{}</depend>\n", "ament_python", "beside"), "beside/setup.py": ""}


@pytest.mark.parametrize(
    ("code", "path", "text", "name", "harm"),
    [
        (
            "DEP101",
            "my_pkg/a.py",
            "import std_srvs.srv\n",
            "std_srvs",
            "in a release it is not installed, and the import",
        ),
        ("DEP101", "setup.py", "import numpy\n", "python3-numpy", "on the build farm `colcon build` stops"),
        ("DEP102", "test/test_a.py", "import cv2\n", "python3-opencv", "on the build farm `colcon test` fails"),
        ("DEP103", "launch/a.launch.xml", STARTS_JOY, "joy", "in a release the launch stops"),
        ("DEP116", "my_pkg/a.py", LOOKS_UP, "joy", "in a release the node ends"),
    ],
)
def test_what_a_package_beside_this_one_declares_is_missing_in_a_release(
    code: str, path: str, text: str, name: str, harm: str
) -> None:
    """Who builds both has it, as rosdep reads all of the workspace."""
    setup = setup_py(scripts("a = my_pkg.a:main"))
    own = {f"own/{each}": body for each, body in {**PYTHON, "setup.py": setup}.items()}
    own |= {"own/start.sh": f"ros2 launch {path}\n"} if code == "DEP103" else {}
    before = text + setup if path == "setup.py" else text
    beside = {each: body.format(name) for each, body in BESIDE.items()}
    released = {**beside, "tracks.yaml": "tracks: {}\n"}
    for others, where, level in (
        ({}, "on a clean machine", "warning"), (beside, harm, "info"), (released, harm, "warning"),
    ):  # fmt: skip
        (found,) = lint_files({**own, f"own/{path}": before, **others}, [code]).findings
        assert where in found.message
        assert found.severity.value == level


@pytest.mark.parametrize(
    ("needs", "where"),
    [("sensor_msgs", "in a release"), ("rclpy", "on a clean machine"), ("beside_too", "in a release")],
)
def test_what_a_package_beside_this_one_brings_is_missing_in_a_release(needs: str, where: str) -> None:
    """`rosdep install` installs sensor_msgs for the other package, and with it geometry_msgs."""
    own = {**{f"own/{each}": body for each, body in PYTHON.items()}, "own/my_pkg/a.py": "import geometry_msgs.msg\n"}
    more = {
        "more/package.xml": manifest("  <depend>sensor_msgs</depend>\n", "ament_python", "beside_too"),
        "more/setup.py": "",
    }
    beside = {each: body.format(needs) for each, body in BESIDE.items()}
    (found,) = lint_files({**own, **beside, **(more if needs == "beside_too" else {})}, ["DEP101"]).findings
    assert where in found.message


@pytest.mark.parametrize(("code", "path"), [("DEP101", "my_pkg/a.py"), ("DEP102", "test/test_a.py")])
def test_what_a_package_beside_declares_under_another_key_is_there(code: str, path: str) -> None:
    """Ubuntu has the module, and PyPI: either key installs it."""
    own = {**{f"own/{each}": body for each, body in PYTHON.items()}, f"own/{path}": "import transforms3d\n"}
    for key, is_there in (("python-transforms3d-pip", True), ("python3-numpy", False)):
        beside = {each: body.format(key) for each, body in BESIDE.items()}
        (found,) = lint_files({**own, **beside}, [code]).findings
        assert ("on a clean machine" not in found.message) is is_there


def test_what_a_package_beside_declares_is_missing_on_the_build_farm() -> None:
    own = {f"own/{path}": text for path, text in existing_files(BACKDROPS["interfaces"]).items()}
    own["own/msg/Place.msg"] = "geometry_msgs/Pose2D pose\n"
    own["own/CMakeLists.txt"] = CMAKE.replace(
        "ament_package", "rosidl_generate_interfaces(${PROJECT_NAME} msg/Place.msg)\nament_package"
    )
    beside = {each: body.format("geometry_msgs") for each, body in BESIDE.items()}
    for others, where, level in (({}, "on a clean machine", "warning"), (beside, "on the build farm", "info")):
        (found,) = lint_files({**own, **others}, ["DEP108"]).findings
        assert found.severity.value == level
        assert f"{where} the generated code does not build" in found.message


@pytest.mark.parametrize(
    ("lines", "ends"),
    [
        ("find_package(Boost REQUIRED)", 'stops with "Could NOT find Boost"'),
        ("find_package(Boost REQUIRED CONFIG)", 'stops with "Could not find a package configuration file"'),
        ("find_package(Eigen3 REQUIRED)", 'stops with "Could not find a package configuration file"'),
        ("find_package(Boost)\ntarget_link_libraries(a Boost::system)", "at the link with `Boost::system`: "),
        ("find_package(Eigen3)\nament_target_dependencies(a Eigen3)", "at `ament_target_dependencies`: "),
        ("find_package(Eigen3)\nament_export_dependencies(Eigen3)", "the build stops where it is used"),
    ],
)
def test_with_what_cmake_stops(lines: str, ends: str) -> None:
    cmake = CMAKE.replace("ament_package()", f"add_executable(a a.cpp)\n{lines}\nament_package()")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, "a.cpp": "int main() {}\n"}
    (found,) = lint_files(files, ["DEP104"]).findings
    assert ends in found.message
    only = manifest("  <test_depend>boost</test_depend>\n  <test_depend>eigen</test_depend>\n", "ament_cmake")
    (found,) = lint_files({**files, "package.xml": only}, ["DEP201"]).findings
    assert ends in found.message


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        (
            "import xacro\n\n\ndef generate_launch_description():\n    return xacro\n",
            "the launch stops with ModuleNotFoundError",
        ),
        ("def generate_launch_description():\n    return get_package_share_directory('xacro')\n", "'xacro' not found"),
    ],
)
def test_how_a_launch_ends_without_what_is_for_the_build_alone(text: str, ends: str) -> None:
    start = "from ament_index_python.packages import get_package_share_directory\n"
    body = manifest("  <build_depend>xacro</build_depend>\n")
    files = {**PYTHON, "package.xml": body, "launch/a.launch.py": start + text}
    found = [each.message for each in lint_files(files, ["DEP201"]).findings if "`xacro`" in each.message]
    assert len(found) == 1
    assert ends in found[0]
