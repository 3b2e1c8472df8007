"""DEP202: what keeps it quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

NODE = "import rclpy\n"
NODE_TARGET = "add_executable(node src/node.cpp)"
CPP = existing_files(BACKDROPS["ament_cmake"])


def names(clean: dict[str, str], depends: str, **files: str) -> list[str]:
    tree = {**clean, "package.xml": manifest(f"  {depends}\n"), "my_pkg/node.py": NODE}
    tree |= {path.replace("__", "/", 1): text for path, text in files.items()}
    return [f.message.split("`")[1] for f in lint_files(tree, ["DEP202"]).findings]


def test_an_unused_one_is_named(clean) -> None:
    assert names(clean, "<depend>message_filters</depend>") == ["message_filters"]
    assert names(clean, "<depend>python3-numpy</depend>") == ["python3-numpy"]


@pytest.mark.parametrize(
    "depends",
    [
        "<exec_depend>robot_state_publisher</exec_depend>",
        "<exec_depend>can-utils</exec_depend>",
        "<test_depend>python3-pytest</test_depend>",
        "<depend>rclpy</depend>",
    ],
)
def test_what_may_be_started_by_name_or_is_used_is_not(clean, depends: str) -> None:
    assert names(clean, depends) == []


def test_launch_files_and_parameters_use_things(clean) -> None:
    launch = "<launch>\n  <node pkg='nav_msgs' exec='x'/>\n</launch>\n"
    assert names(clean, "<depend>nav_msgs</depend>", **{"launch__a.launch.xml": launch}) == []
    assert names(clean, "<depend>nav_msgs</depend>", **{"config__a.yaml": "plugin: nav_msgs/X\n"}) == []


def test_imports_of_another_name_and_in_tests_count(clean) -> None:
    assert names(clean, "<depend>python3-opencv</depend>", **{"my_pkg__see.py": "import cv2\n"}) == []
    assert names(clean, "<depend>tf2_ros_py</depend>", **{"my_pkg__tf.py": "import tf2_ros\n"}) == []
    assert names(clean, "<depend>nav_msgs</depend>", **{"test__test_a.py": "import nav_msgs.msg\n"}) == []


def test_a_package_without_code_gathers_on_purpose(clean) -> None:
    files = {**clean, "package.xml": manifest("  <depend>nav_msgs</depend>\n")}
    assert lint_files(files, ["DEP202"]).findings == ()


def of_cmake(depends: str, *lines: str, **files: str) -> list[str]:
    text = CMAKE.replace("ament_package()", "\n".join([NODE_TARGET, *lines, "ament_package()"]))
    tree = {**CPP, "package.xml": manifest(f"  {depends}\n", "ament_cmake"), "CMakeLists.txt": text}
    tree |= {path.replace("__", "/", 1): text for path, text in files.items()}
    return [f.message.split("`")[1] for f in lint_files(tree, ["DEP202"]).findings]


def test_what_leaves_no_trace_in_a_package_of_cmake() -> None:
    assert of_cmake("<depend>nav_msgs</depend>") == ["nav_msgs"]
    assert of_cmake("<test_depend>launch_testing</test_depend>") == ["launch_testing"]


@pytest.mark.parametrize(
    "depends",
    [
        "<exec_depend>nav2_amcl</exec_depend>",
        "<depend>eigen</depend>",
        "<depend>who_knows_what</depend>",
        "<test_depend>ament_lint_auto</test_depend>",
        "<test_depend>nav2_amcl</test_depend>",
    ],
)
def test_what_may_be_used_without_a_trace(depends: str) -> None:
    assert of_cmake(depends) == []


def test_traces_in_a_package_of_cmake() -> None:
    nav = "<depend>nav_msgs</depend>"
    assert of_cmake(nav, "find_package(nav_msgs)") == []
    assert of_cmake(nav, "foreach(p nav_msgs)\nfind_package(${p})\nendforeach()") == []
    assert of_cmake(nav, src__a="", **{"src__a.cpp": "#include <nav_msgs/msg/odometry.hpp>\n"}) == []
    assert of_cmake(nav, **{"test__a.py": "import nav_msgs\n"}) == []
    assert of_cmake(nav, "include(${SOMEWHERE}/all.cmake)") == []


def test_what_only_runs_needs_no_depend() -> None:
    launch = "<launch>\n  <node pkg='joy' exec='joy_node'/>\n</launch>\n"
    body = {"package.xml": manifest("  <depend>joy</depend>\n", "ament_cmake"), "launch/a.launch.xml": launch}
    (finding,) = lint_files({**CPP, **body}, ["DEP202"]).findings
    assert "write <exec_depend>joy</exec_depend>" in finding.message
    (edit,) = finding.fix.operations
    assert edit.text == "<exec_depend>joy</exec_depend>"


def test_a_python_library_that_nothing_imports(clean) -> None:
    assert names(clean, "<exec_depend>python3-enum34</exec_depend>") == ["python3-enum34"]
    assert names(clean, "<exec_depend>python3-numpy</exec_depend>", **{"my_pkg__see.py": "import numpy\n"}) == []


@pytest.mark.parametrize("tag", ["exec_depend", "test_depend"])
def test_interfaces_are_used_by_code_alone(tag: str) -> None:
    nav = f"<{tag}>nav_msgs</{tag}>"
    assert of_cmake(nav) == ["nav_msgs"]
    assert of_cmake(nav, **{"README.md": "It needs nav_msgs.\n"}) == []
    assert of_cmake(nav, **{"test__a.py": "import nav_msgs\n"}) == []
    assert of_cmake(nav, **{"src__a.cpp": "#include <nav_msgs/msg/odometry.hpp>\n"}) == []
    assert gathered(nav) == []
    assert of_cmake(f"<{tag}>service_msgs</{tag}>") == []


def gathered(depends: str, lines: str = "", **files: str) -> list[str]:
    """Return what is said of a package that builds nothing."""
    body = manifest(f"  {depends}\n", "ament_cmake")
    text = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    tree = {**CPP, "package.xml": body, "CMakeLists.txt": text}
    tree |= {path.replace("__", "/", 1): text for path, text in files.items()}
    return [f.message.partition(": ")[0] for f in lint_files(tree, ["DEP202"]).findings]


NOT_BUILT = "`nav_msgs` is declared as <depend>, and nothing that is built uses it"


def test_what_builds_nothing_needs_nothing_for_the_build() -> None:
    nav = "<depend>nav_msgs</depend>"
    assert gathered(nav) == [NOT_BUILT]
    assert gathered(nav, **{"README.md": "It needs nav_msgs.\n"}) == [NOT_BUILT]
    assert gathered(nav, "message(nav_msgs)") == []
    assert gathered(nav, "ament_auto_find_build_dependencies()") == []
    assert gathered(nav, **{"test__a.py": "import nav_msgs\n"}) == []
    assert gathered("<build_depend>nav_msgs</build_depend>") == []
    assert gathered("<exec_depend>nav_msgs</exec_depend>") == []


def test_a_document_shows_that_a_package_is_meant_and_not_for_what() -> None:
    readme = {"README.md": "It needs nav_msgs.\n"}
    assert of_cmake("<depend>nav_msgs</depend>", **readme) == ["nav_msgs"]
    assert of_cmake("<build_depend>nav_msgs</build_depend>", **readme) == []
    assert of_cmake("<depend>nav_msgs</depend>", "ament_auto_find_build_dependencies()", **readme) == []
    launch = {"launch__a.launch.xml": "<launch>\n  <node pkg='nav_msgs' exec='x'/>\n</launch>\n"}
    assert of_cmake("<build_depend>nav_msgs</build_depend>", **readme, **launch) == ["nav_msgs"]
    assert of_cmake("<depend>nav_msgs</depend>", **{"test__a.py": "import nav_msgs\n"}, **launch) == ["nav_msgs"]


def test_headers_in_a_shared_folder_are_those_of_one_package() -> None:
    """The workspace knows which package has which header; of others any may be meant."""
    line = "<depend>moveit_core</depend><depend>moveit_acme</depend>"
    include = {"src__a.cpp": "#include <moveit/acme/x.hpp>\n"}
    assert of_cmake(line, **include) == []
    files = {f"a/{path}": text for path, text in CPP.items()}
    text = CMAKE.replace("ament_package()", NODE_TARGET + "\nament_package()")
    files |= {
        "a/package.xml": manifest(line, "ament_cmake"),
        "a/CMakeLists.txt": text,
        "a/src/a.cpp": include["src__a.cpp"],
    }
    files |= {"b/package.xml": manifest("", "ament_cmake", "moveit_acme"), "b/CMakeLists.txt": CMAKE}
    files["b/include/moveit/acme/x.hpp"] = ""
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP202"]).findings] == ["moveit_core"]


def test_python_that_cannot_be_read_may_use_anything(clean) -> None:
    assert names(clean, "<depend>nav_msgs</depend>", **{"my_pkg__broken.py": "import nav_msgs.msg\ndef (\n"}) == []
    assert names(clean, "<depend>nav_msgs</depend>", **{"my_pkg__broken.py": "def (\n"}) == []


@pytest.mark.parametrize("tag", ["exec_depend", "test_depend"])
@pytest.mark.parametrize(
    "name, path, text",
    [
        ("position_controllers", "config__a.yaml", "type: position_controllers/JointGroupPositionController\n"),
        ("joint_state_broadcaster", "launch__a.py", "SPAWN = 'joint_state_broadcaster'\n"),
        ("ros2param", "README.md", "Then run ros2 param list.\n"),
        ("ros2topic", "test__a.py", "CMD = ['ros2', 'topic', 'echo']\n"),
        ("ros2bag", "scripts__a.sh", "ros2 \\\n  bag play\n".replace("\\\n", "")),
        ("ros2service", "launch__a.launch.xml", "<launch>\n  <executable cmd='ros2service call'/>\n</launch>\n"),
    ],
)
def test_what_is_always_named_where_it_is_used(tag: str, name: str, path: str, text: str) -> None:
    line = f"<{tag}>{name}</{tag}>"
    assert of_cmake(line) == [name]
    assert of_cmake(line, **{path: text}) == []
    assert gathered(line) == []


@pytest.mark.parametrize(
    "name", ["nav2_mppi_controller", "rqt_joint_trajectory_controller", "ros2run", "ros2launch", "ros2cli"]
)
def test_what_is_used_without_its_name(name: str) -> None:
    assert of_cmake(f"<exec_depend>{name}</exec_depend>") == []


def test_another_command_is_no_use() -> None:
    assert of_cmake("<exec_depend>ros2topic</exec_depend>", **{"README.md": "ros2 topics, ros2 node, topic\n"}) == [
        "ros2topic"
    ]


@pytest.mark.parametrize(
    "plugin, unused", [("position_controllers/Group", []), ("other/Group", ["position_controllers"])]
)
def test_parameters_of_another_package_name_controllers(plugin: str, unused: list[str]) -> None:
    text = CMAKE.replace("ament_package()", NODE_TARGET + "\nament_package()")
    files = {f"a/{path}": text for path, text in CPP.items()} | {"a/CMakeLists.txt": text}
    files["a/package.xml"] = manifest("  <exec_depend>position_controllers</exec_depend>\n", "ament_cmake")
    files |= {"b/package.xml": manifest("", "ament_cmake", "b"), "b/CMakeLists.txt": CMAKE}
    files["b/config/a.yaml"] = f"arm:\n  type: {plugin}\n"
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP202"]).findings] == unused


PLUGIN = '<library path="x">\n  <class type="b::X" base_class_type="{}"/>\n</library>\n'


@pytest.mark.parametrize(
    "base, program, unused",
    [
        ("controller_interface::ControllerInterface", "", ["b"]),
        ("controller_interface::ControllerInterface", "node", []),
        ("rviz_common::Display", "", []),
    ],
)
def test_a_package_of_the_workspace_that_holds_controllers_alone(base: str, program: str, unused: list[str]) -> None:
    text = CMAKE.replace("ament_package()", NODE_TARGET + "\nament_package()")
    files = {f"a/{path}": text for path, text in CPP.items()} | {"a/CMakeLists.txt": text}
    files["a/package.xml"] = manifest("  <exec_depend>b</exec_depend>\n", "ament_cmake")
    lines = "pluginlib_export_plugin_description_file(controller_interface plugins.xml)\n"
    lines += "add_executable(node a.cpp)\ninstall(TARGETS node DESTINATION lib/b)\n" if program else ""
    files |= {"b/package.xml": manifest("", "ament_cmake").replace("my_pkg", "b"), "b/plugins.xml": PLUGIN.format(base)}
    files["b/CMakeLists.txt"] = CMAKE.replace("my_pkg", "b").replace("ament_package()", lines + "ament_package()")
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP202"]).findings] == unused
