"""Levels of values in parameter files, by who reads them: nodes that are started, or by a name alone, or nobody."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

INSTALL = CMAKE.replace(
    "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
)
TALKER_BUILD = INSTALL.replace(
    "install(DIRECTORY config",
    "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\ninstall(DIRECTORY",
)
LAUNCH = "<launch>{}</launch>\n"
NAMES = LAUNCH.format('<let name="f" value="$(find-pkg-share my_pkg)/config/robot.yaml"/>')
STARTS = LAUNCH.format(
    '<node pkg="{}" exec="{}" name="{}"><param from="$(find-pkg-share my_pkg)/config/robot.yaml"/></node>'
)
SMOOTHER = "velocity_smoother:\n  ros__parameters:\n    odom_duration: 1\n    feedback: 1\n"
SAVER = "map_saver:\n  ros__parameters:\n    save_map_timeout: 5000\n    free_thresh_defualt: 0.25\n"
BLOCK = "{}:\n  ros__parameters:\n    use_sim_time: true\n"
SEVERAL = SMOOTHER + BLOCK.format("planner_server") + BLOCK.format("bt_navigator")
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    drive: {type: diff_drive_controller/DiffDriveController}
drive:
  ros__parameters:
    publish_rate: 50
    publish_rat: 50.0
"""
LAYER = (
    "costmap:\n  ros__parameters:\n    static:\n      plugin: nav2_costmap_2d::StaticLayer\n"
    "      map_subscribe_transient_local: 1\n"
)
CODE = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    declare_parameter("rate", 1.0);
    declare_parameter("port", "/dev/ttyUSB0");
    declare_parameter("global_frame", "map");
  }
};
"""


def given(text: str, launch: str = NAMES, **more: str) -> Example:
    """A package with a parameter file and a launch file."""
    named = {name.replace("__", "/").replace("_DOT_", "."): content for name, content in more.items()}
    files = {"CMakeLists.txt": INSTALL, "config/robot.yaml": text, "launch/a.launch.xml": launch, **named}
    return Example(on="ament_cmake", bad=files, good={})


def declared(values: str, launch: str = NAMES, **more: str) -> Example:
    return given(f"talker:\n  ros__parameters:\n{values}", launch, src__talker_DOT_cpp=CODE, **more)


LINES = "    rate: {}\n    port: {}\n    global_flame: a\n"
WORKSPACE = {"src/my_pkg/package.xml": manifest("", "ament_cmake"), "src/my_pkg/CMakeLists.txt": INSTALL}


def below(readme: str, files: dict[str, str]) -> Example:
    """A package of a repository with a page."""
    inner = {f"src/my_pkg/{path}": text for path, text in files.items()}
    return Example(
        on="", bad={**WORKSPACE, "src/my_pkg/CMakeLists.txt": INSTALL, "README.md": readme, **inner}, good={}
    )


LIFECYCLE = """\
from launch import LaunchDescription
from launch_ros.actions import LifecycleNode, Node


def generate_launch_description():
    return LaunchDescription([LifecycleNode(package='a', executable='b', name='c'), Node(executable='b', nam='c')])
"""
PAGES = (
    "Built on Foxy.\n",
    "For foxy and humble.\n",
    "A foxytail.\n",
    "`/opt/ros/foxy/setup.bash`, Dashing\n",
    "ros\n",
)
VALUES = {"config/robot.yaml": f"talker:\n  ros__parameters:\n{LINES.format(1, 2)}", "src/talker.cpp": CODE}
BOTH = (
    given(SMOOTHER),
    given(SMOOTHER, STARTS.format("nav2_velocity_smoother", "velocity_smoother", "velocity_smoother")),
    given(SEVERAL),
    given(SEVERAL.replace("bt_navigator", "somebodys")),
    given(SEVERAL + SAVER),
    given(SAVER, STARTS.format("nav2_map_server", "map_saver_server", "map_saver")),
    given(SAVER, STARTS.format("nav2_map_server", "map_server", "map_server")),
    given(CONTROLLERS),
    given(CONTROLLERS, LAUNCH.format("")),
    given(LAYER),
    declared(LINES.format(1, 2)),
    declared(LINES.format(1, 2), LAUNCH.format("")),
    *(
        declared(LINES.format(1.0, each))
        for each in ("$(var port)", "'${PORT}'", "a<port>b", "a__PORT__", "@PORT@", "2")
    ),
    *(declared(LINES.format(each, "a")) for each in ("'__RATE__'", "'5__'", "'<5>'", "'5'")),
)
OLD = "import os\n" + LIFECYCLE.replace("Node(executable='b', nam='c')", "Node(package='a', node_executable='b')")
OLD_XML = LAUNCH.format('<node pkg="a" type="b"/><let name="c" value="d"/>')
SPAWNS = LAUNCH.format('<node pkg="controller_manager" exec="spawner.py"/><node pkg="nav2_recoveries" exec="{}"/>')
REMOVED = SPAWNS.format("recoveries_server")
RECOVERIES = "recoveries_server:\n  ros__parameters:\n    spin:\n      plugin: {}\n"
GALACTIC = ("Built on Galactic.\n", "Galactic, or Humble.\n")
FRAMES = LAUNCH.format(
    '<node pkg="tf2_ros" exec="a"><param name="/frame_id" value="a"/><param name="/child_frame_id" value="b"/></node>'
    '<node pkg="tf2_ros" exec="a"><param name="/frame_id" value="c"/></node>'
)
NEVER_ADDED = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    load = ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'start', 'arm'])
    return LaunchDescription([])
"""
LOADS = NEVER_ADDED.replace("([])", "([load])").replace(
    "\n\n\n", "\nfrom launch.conditions import IfCondition\n\n\n", 1
)
NAMED = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    name = {}
    return LaunchDescription([LogInfo(msg={})])
"""
CONFIGURED = "LaunchConfiguration('a')"
UNUSED = (
    (f'f"x{{{CONFIGURED}}}"', "'a'"),
    (f'f"x{{{CONFIGURED}}}"', "name"),
    (f"{CONFIGURED} + 'x'", "'a'"),
)
STARTED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    given = [{VALUES}]
    one = Node(package='PACKAGE', executable='PROGRAM', parameters=given, condition=CONDITION)
    two = Node(package='PACKAGE', executable='PROGRAM', parameters=given)
    return LaunchDescription([DeclareLaunchArgument('a', default_value='false'), ADDED])
"""

REFUSED = tuple(
    below("ros\n", {"launch/a.launch.xml": LAUNCH.format(outside + inside)})
    for inside in (
        '<node pkg="robot_state_publisher" exec="robot_state_publisher" name="a"/>',
        '<node pkg="image_rotate" exec="image_rotate"><param name="target_x" value="1"/></node>',
        '<node pkg="tf2_ros" exec="a"><param name="/use_sim_time" value="true"/></node>',
    )
    for outside in ('<param name="a" value="b"/>', '<let name="a" value="$(find my_pkg)"/>', "")
)


def started(package: str, program: str, values: str, added: str, condition: str = "None") -> Example:
    """A Python launch file that makes two nodes, and may add none of them; with values for both."""
    text = STARTED.replace("PACKAGE", package).replace("PROGRAM", program).replace("VALUES", values)
    text = text.replace("ADDED", added).replace("CONDITION", condition)
    files = {"CMakeLists.txt": TALKER_BUILD, "launch/a.launch.py": text, "src/talker.cpp": CODE}
    return Example(on="ament_cmake", bad=files, good={})


IF = "IfCondition(LaunchConfiguration('a'))"
ADDED = (("", "None"), ("one", IF), ("two", "None"), ("one, two", IF))
ROTATED = ("image_rotate", "image_rotate", "'target_x': '-1.5', 'target_fram_id': ''")
TALKED = ("my_pkg", "talker", "'rate': 1, 'port': 'a', 'globalframe': 'a', 'use_sim_tme': True")
IDLE = tuple(started(*each, *added) for each in (ROTATED, TALKED) for added in ADDED)
PUBLISHED = tuple(started("robot_state_publisher", "robot_state_publisher", "'rate': 1.0", *each) for each in ADDED)
CASES = {
    "LCH002": (
        *(below(each, {"launch/a.launch.xml": REMOVED}) for each in (*PAGES, *GALACTIC)),
        *(below("ros\n", {f"launch/{name}.launch.xml": REMOVED}) for name in ("a_foxy", "Galactic", "foxes", "humble")),
        below("Foxy\n", {"launch/a.launch.xml": SPAWNS.format("recoveries_sevrer")}),
        *(
            below(page, {"launch/a.launch.xml": REMOVED, "config/nav.yaml": RECOVERIES.format(name)})
            for page, name in (
                ("", "nav2_recoveries/Spin"),
                ("", "nav2_behaviors/Spin"),
                (GALACTIC[1], "nav2_recoveries/Spin"),
            )
        ),
        *(
            Example(
                bad={
                    f"{each}/arm/package.xml": manifest(build_type="cmake"),
                    f"{each}/arm/launch/a.launch.xml": REMOVED,
                },
                good={},
                on="",
            )
            for each in ("nav_galactic", "galictic", "foxy-devel", "foxy_humble", "galactica", "src")
        ),
    ),
    "LCH005": (
        *(below(each, {"launch/a.launch.py": OLD}) for each in (*PAGES, GALACTIC[0])),
        below(PAGES[0], {"launch/a.launch.xml": OLD_XML}),
        below("Jazzy.\n", {"launch/a.launch.py": NEVER_ADDED}),
        *(below(each, {"launch/a.launch.py": LOADS}) for each in ("Any.\n", PAGES[0], *GALACTIC)),
        *(
            below(
                "Jazzy.\n", {"launch/a.launch.py": LOADS.replace("'arm'])", f"'arm'], condition=IfCondition({each}))")}
            )
            for each in ("'0'", "unknown()")
        ),
        below("", {"launch/a.launch.py": OLD.replace("    return", "    if os.environ.get('OLD'):\n        return")}),
        below(PAGES[0], {"launch/a.launch.py": OLD.replace("node_executable", "type")}),
        Example(
            on="",
            bad={"foxy/my_pkg/package.xml": manifest(build_type="cmake"), "foxy/my_pkg/launch/a.launch.py": OLD},
            good={},
        ),
    ),
    "PRM006": (*BOTH, *IDLE, *REFUSED, *(below(each, {**VALUES, "launch/a.launch.xml": NAMES}) for each in PAGES)),
    "PRM008": (*PUBLISHED, *REFUSED),
    "PRM007": (*BOTH, *IDLE, *REFUSED, given("a:\n  ros__parameters: {}\n", FRAMES)),
    "LCH014": (
        *(below(each, {"launch/a.launch.py": LIFECYCLE}) for each in PAGES),
        *(below("", {"launch/a.launch.py": NAMED.format(*each)}) for each in UNUSED),
    ),
}
