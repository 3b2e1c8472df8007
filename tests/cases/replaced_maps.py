"""Maps in a home folder in place of which a launch file of nav2 is given another one."""

from __future__ import annotations

from rospkg_cli.example import Example, setup_py

MAP = "/home/ada/ws/src/my_pkg/maps/map.yaml"
DATA = """\
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/config', ['config/nav.yaml']),
        ('share/' + package_name + '/maps', ['maps/map.yaml', 'maps/map.pgm']),
        ('share/' + package_name + '/launch', ['launch/a.launch.xml', 'launch/b.launch.py']),
"""
SETUP = setup_py().replace("        ('share/' + package_name, ['package.xml']),\n", DATA)
NAV, HERE = "$(find-pkg-share nav2_bringup)/launch", "$(find-pkg-share my_pkg)"
PARAMS = f'<arg name="params_file" value="{HERE}/config/nav.yaml"/>'
GIVEN = f'<arg name="map" value="{HERE}/maps/map.yaml"/>'
BY_ARGUMENT = '<arg name="map" value="$(var map)"/>'
REWRITES = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    file = os.path.join(get_package_share_directory('my_pkg'), 'config', 'nav.yaml')
    file = RewrittenYaml(source_file=file, param_rewrites={{'{}': LaunchConfiguration('map')}})
    return LaunchDescription([Node(package='nav2_map_server', executable='map_server', parameters=[file])])
"""


def includes(*included: str, before: str = "", node: str = "map_server", more: str = "", path: str = MAP) -> Example:
    """Return a package that includes files with arguments, each `path: arguments`."""
    lines = [each.partition(": ") for each in included]
    inner = "".join(f'  <include file="{path}">{arguments}</include>\n' for path, _, arguments in lines)
    files = {
        "setup.py": SETUP,
        "maps/map.yaml": "image: map.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\n",
        "maps/map.pgm": "P2 1 1 1 0\n",
        "launch/a.launch.xml": f"<launch>\n{before}{inner}</launch>\n",
        "launch/b.launch.py": more or "# nothing yet\n",
        "config/nav.yaml": f"{node}:\n  ros__parameters:\n    yaml_filename: {path}\n",
    }
    return Example(bad=files, good={})


BRINGUP = f"{NAV}/bringup_launch.py: {PARAMS}"

CASES = {
    "DEP118": (
        includes(BRINGUP),
        includes(BRINGUP + GIVEN),
        includes(BRINGUP + GIVEN, node="other_server"),
        includes(BRINGUP + BY_ARGUMENT, before=f'  <arg name="map" default="{HERE}/maps/map.yaml"/>\n'),
        includes(BRINGUP + BY_ARGUMENT, before='  <arg name="map"/>\n'),
        includes(BRINGUP + BY_ARGUMENT, before='  <arg name="map" default=""/>\n'),
        includes(BRINGUP + '<arg name="map" value=""/>'),
        includes(BRINGUP + GIVEN, f"{NAV}/navigation_launch.py: {PARAMS}"),
        includes(f"{NAV}/localization_launch.py: {GIVEN}{PARAMS}", f"{NAV}/navigation_launch.py: {PARAMS}"),
        includes(BRINGUP + GIVEN, f"{HERE}/launch/c.launch.xml: {PARAMS}"),
        includes(more=REWRITES.format("yaml_filename")),
        includes(more=REWRITES.format("use_sim_time")),
    ),
    "PRM010": (
        includes(BRINGUP, path=f"{HERE}/maps/none.yaml"),
        includes(BRINGUP + GIVEN, path=f"{HERE}/maps/none.yaml"),
    ),
}
