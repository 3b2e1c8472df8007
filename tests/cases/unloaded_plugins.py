"""Names of plugins that nothing loads: controllers that are not spawned, and files that nothing names (PLG003)."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003

CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm_controller:
      type: my_pkg/Planner
    left_arm_controller:
      type: my_pkg/Plan
"""
SPAWNS = """\
<launch>
  <let name="config" value="$(find-pkg-share my_pkg)/config/{}"/>
  <node pkg="controller_manager" exec="spawner" args="{}"/>
</launch>
"""
JOINED = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = 'config/robot.yaml'
    other = 'arm_controller'
    name = {}
    given = [name, config, other]
    return LaunchDescription([Node(package='controller_manager', executable='spawner', arguments=given)])
"""


def spawned(text: str, path: str = "launch/a.launch.xml", values: str = CONTROLLERS, **more: str) -> Example:
    files = {
        **plg003.FILES,
        "CMakeLists.txt": plg003.PACKAGE.replace("(DIRECTORY config", "(DIRECTORY config launch"),
        "package.xml": manifest("  <depend>nav2_core</depend>\n  <depend>pluginlib</depend>\n", "ament_cmake"),
        f"config/{more.pop('name', 'robot')}.yaml": values,
        path: text,
        **{f"{name}.md": page for name, page in more.items()},
    }
    return Example(bad=files, good={}, on="ament_cmake")


BOTH, ONE, NONE = "arm_controller left_arm_controller", "arm_controller", "joint_state_broadcaster"
CASES = {
    "PLG003": (
        *(spawned(SPAWNS.format("robot.yaml", names)) for names in (BOTH, ONE, NONE)),
        spawned(SPAWNS.format("robot.yaml", ONE), README="`ros2 control load_controller left_arm_controller`\n"),
        spawned(SPAWNS.format("robot.yaml", ONE).replace("<let", "<!-- left_arm_controller -->\n  <let")),
        spawned(SPAWNS.format("robot.yaml", ONE), values=CONTROLLERS.replace("controller_manager", "manager")),
        *(
            spawned(JOINED.format(text), "launch/a.launch.py")
            for text in (
                "f'{config}_arm_controller'",
                "'left_' + other",
                "config + '_controller'",
                "'a'",
                "known['left_arm_controller']['default']",
            )
        ),
        *(spawned(SPAWNS.format(name, BOTH)) for name in ("robot.yaml", "other.yaml")),
        spawned(SPAWNS.format("other.yaml", BOTH), name="ros2_controllers"),
        spawned(SPAWNS.format("other.yaml", BOTH), values=plg003.CONFIG.replace("my_pkg/Planner", "my_pkg::Planner")),
        spawned("<launch/>\n", "config/a.xml", plg003.CONFIG.replace("my_pkg/Planner", "my_pkg::Planner")),
    )
}
