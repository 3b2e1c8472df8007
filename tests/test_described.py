"""Packages that robots, layouts and parameter files name: when to ask for them, and how loudly."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='{}', executable='x')])
"""
GIVEN = "'x', parameters=[share + '/config/nav.yaml']"
NAVIGATION = """\
planner_server:
  ros__parameters:
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
controller_server:
  ros__parameters:
    FollowPath:
      plugin: "dwb_core::DWBLocalPlanner"
"""


def said(files: dict[str, str], *declared: str) -> list[tuple[str, str]]:
    body = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in declared)
    found = lint_files({**PYTHON, "package.xml": manifest(body), **files}, ["DEP106"]).findings
    return [(finding.message.split("`")[1], finding.severity.value) for finding in found]


def robot(inside: str) -> dict[str, str]:
    root = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="a">'
    return {"urdf/a.urdf.xacro": f'{root}\n{inside}\n<link name="b"/></robot>\n'}


def test_files_of_other_packages() -> None:
    mesh = (
        '<link name="c"><visual><geometry><mesh filename="package://ur_description/a.stl"/></geometry></visual></link>'
    )
    page = {"README.md": "    xacro urdf/a.urdf.xacro > a.urdf\n"}
    assert said({**robot(mesh), **page}) == [("ur_description", "warning")]
    assert said(robot(mesh)) == [("ur_description", "info")]
    assert said(robot(mesh), "ur_description") == []
    world = {"worlds/a.sdf": "<sdf><uri>package://ur_description/a.stl</uri></sdf>\n"}
    assert said(world) == [("ur_description", "info")]
    filled = {"worlds/a.sdf": world["worlds/a.sdf"].replace("package://", "$(find ").replace("tion/", "tion)/")}
    assert said({**filled, "README.md": "    gz sim worlds/a.sdf\n"}) == [("ur_description", "info")]
    assert said({**world, "README.md": "    gz sim worlds/a.sdf\n"}) == [("ur_description", "warning")]


@pytest.mark.parametrize(
    "inside",
    [
        '<xacro:include filename="$(find my_pkg)/urdf/b.xacro"/>',
        '<!-- <xacro:include filename="$(find ur_description)/urdf/b.xacro"/> -->',
        '<xacro:include filename="$(find $(arg package))/urdf/b.xacro"/>',
    ],
)
def test_what_a_robot_names_without_need(inside: str) -> None:
    assert said(robot(inside)) == []


def test_a_robot_that_is_not_installed_does_not_count() -> None:
    text = robot('<xacro:include filename="$(find ur_description)/urdf/b.xacro"/>')["urdf/a.urdf.xacro"]
    assert said({"drafts/a.urdf.xacro": text}) == []


def test_what_a_launch_file_asks_for_is_said_there() -> None:
    include = robot('<xacro:include filename="$(find ur_description)/urdf/b.xacro"/>')
    assert said({**include, "launch/a.launch.py": LAUNCH.format("ur_description")}) == []


def test_the_plugins_of_a_robot_are_a_matter_of_who_drives_it() -> None:
    inside = "<ros2_control><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware></ros2_control>"
    assert said(robot(inside)) == [("gz_ros2_control", "info")]


def test_layouts_name_plugins() -> None:
    layout = "Panels:\n  - Class: {}\n"
    assert said({"rviz/a.rviz": layout.format("nav2_rviz_plugins/Navigation 2")}) == [("nav2_rviz_plugins", "info")]
    for name in ("rviz_common/Displays", "rviz_default_plugins/Grid", "nobody_knows/It"):
        assert said({"rviz/a.rviz": layout.format(name)}) == []


def test_parameters_name_plugins_that_launch_files_start() -> None:
    one = NAVIGATION.partition("controller_server")[0]
    files = {"config/nav.yaml": one, "launch/a.launch.py": LAUNCH.format("nav2_planner").replace("'x'", GIVEN)}
    assert said(files) == [("nav2_navfn_planner", "warning")]
    assert said({"config/nav.yaml": one}) == [("nav2_navfn_planner", "info")]


@pytest.mark.parametrize("declared", ["navigation2", "nav2_bringup"])
def test_plugins_that_come_with_others(declared: str) -> None:
    assert said({"config/nav.yaml": NAVIGATION}, declared) == []


def test_plugins_that_come_with_what_is_launched() -> None:
    assert said({"config/nav.yaml": NAVIGATION, "launch/a.launch.py": LAUNCH.format("nav2_bringup")}) == []


def test_plugins_that_the_started_nodes_need_themselves() -> None:
    layers = "local_costmap:\n  local_costmap:\n    ros__parameters:\n      plugins: [inflation_layer]\n"
    layers += "      inflation_layer:\n        plugin: 'nav2_costmap_2d::InflationLayer'\n"
    for started, expected in (("nav2_planner", []), ("nav2_map_server", [("nav2_costmap_2d", "warning")])):
        launch = LAUNCH.format(started).replace("'x'", GIVEN)
        assert said({"config/nav.yaml": layers, "launch/a.launch.py": launch}) == expected


def test_the_parts_of_navigation_are_asked_for_at_once() -> None:
    assert said({"config/nav.yaml": NAVIGATION}) == [("navigation2", "info")]


def test_types_of_interfaces_are_no_plugins() -> None:
    assert said({"config/a.yaml": "a:\n  type: sensor_msgs/Image\n  type: std_srvs/srv/Empty\n"}) == []


def test_a_plugin_of_a_package_around_is_known_by_its_description() -> None:
    described = (
        '<library path="shapes"><class type="acme::Square" name="shapes/Square" base_class_type="rviz_common::Panel"/>'
        "</library>\n"
    )
    cmake = existing_files(BACKDROPS["ament_cmake"])
    around = {f"b/{path}": text for path, text in cmake.items()}
    around["b/package.xml"] = manifest(build_type="ament_cmake", name="acme_shapes")
    around["b/plugins.xml"] = described
    around["b/CMakeLists.txt"] = (
        cmake["CMakeLists.txt"]
        .replace(
            "ament_package()", "pluginlib_export_plugin_description_file(rviz_common plugins.xml)\nament_package()"
        )
        .replace("my_pkg", "acme_shapes")
    )
    files = {f"a/{path}": text for path, text in PYTHON.items()} | around
    files["a/rviz/a.rviz"] = "Panels:\n  - Class: shapes/Square\n"
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP106"]).findings] == ["acme_shapes"]
