"""Arguments that a program refuses: levels that no example shows."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

from .shown_launch_calls import python

NODE = "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--frame-id', 'map']{})"
CREATES = (
    "'-topic', 'robot_description', '-roll', '1.0', '-pitch', '0'",
    "'-entity', 'robot'",
    "'-nam', 'robot', '-file', '-anything'",
    "'-x', '-1', '--z=2', '-name', '-entity', '-allow_renaming', 'true', '-Y', '-0.5', '--ros-args', '-r', 'a:=b'",
    "'-flagfile', 'a', '-entity', 'b'",
)
SPAWN = "Node(package='ros_gz_sim', executable='create', arguments=[{}])"
CASES = {
    "LCH022": (
        python(NODE.format(", condition=IfCondition('false')")),
        python(NODE.format(", condition=IfCondition(LaunchConfiguration('fixed'))")),
        *(python(SPAWN.format(words)) for words in CREATES),
        python(f"{SPAWN.format(CREATES[1])}  # launch_testing"),
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>tf2_ros</exec_depend>\n", "ament_cmake"),
                "launch/a.launch.py": "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
                "def generate_launch_description():\n"
                f"    unused = {NODE.format('')}\n    return LaunchDescription([])\n",
            },
            good={},
        ),
    )
}
