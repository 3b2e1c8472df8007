"""What stands in a `<ros2_control>` (URD001) is told as an info where nothing here reads it."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
ARM = f"""\
<robot {XACRO} name="r">
  <link name="base"/>
  <ros2_control name="arm" type="{{}}">
    <joint name="wrist"><command_interface name="position"><param name="max">{{}}</param></command_interface></joint>
    <joint name="elbow"/>
  </ros2_control>
  <link name="hand"/>
  <joint name="wrist" type="fixed"><parent link="base"/><child link="hand"/></joint>
</robot>
"""
SHOW = "import launch\n\nURDF = 'arm.urdf.xacro'\n"
START = "from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n    return [Node({})]\n"


def arm(kind: str = "system", limit: str = "{pi}", **more: str) -> Example:
    """A package with a robot that a launch file opens, beside another package."""
    files = {
        "my_pkg/package.xml": manifest(build_type="ament_cmake"),
        "my_pkg/CMakeLists.txt": INSTALL,
        "my_pkg/urdf/arm.urdf.xacro": ARM.format(kind, limit),
        "my_pkg/launch/show.launch.py": SHOW,
        "other/package.xml": manifest("", "cmake", "other"),
    }
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}
    return Example(bad={**files, **named}, good={}, on="")


NEEDS = manifest("", "cmake", "other").replace("  <export>", "  <exec_depend>{}</exec_depend>\n  <export>")
CASES = {
    "URD001": (
        arm(),
        arm("systeem"),
        arm(limit="${pii}"),
        arm("systeem", my_pkg__README_DOT_md="Start `ros2 launch gazebo_ros gazebo.launch.py`\n"),
        *(
            arm(my_pkg__launch__more_DOT_launch_DOT_py=START.format(f"package='{package}', executable='{program}'"))
            for package, program in (
                ("controller_manager", "ros2_control_node"),
                ("ros_gz_sim", "create"),
                ("rviz2", "rviz2"),
                ("align", "signs"),
            )
        ),
        arm(other__launch__more_DOT_launch_DOT_py=START.format("package='controller_manager', executable='spawner'")),
        *(arm(other__package_DOT_xml=NEEDS.format(each)) for each in ("gz_ros2_control", "rviz2", "ros_ign_gazebo")),
    )
}
