"""Meshes without a scheme, by what the launch files that open the robot start (URD002)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">
  <link name="a"><visual><geometry><mesh filename="{}"/></geometry></visual></link>
</robot>
"""
FOUND, RELATIVE = "$(find my_pkg)/meshes/a.stl", "meshes/a.stl"
NAME = '<let name="m" value="$(find-pkg-share my_pkg)/urdf/r.urdf.xacro"/>'
PUBLISH = '<node pkg="robot_state_publisher" exec="robot_state_publisher"/>'
OPEN = NAME + PUBLISH
BESIDE = "../meshes/a.stl"
CREATE = '<node pkg="ros_gz_sim" exec="create" args="-file $(find-pkg-share my_pkg)/urdf/r.urdf.xacro -name r"/>'
GAZEBO = '<node pkg="gazebo_ros" exec="spawn_entity.py"/>'
RVIZ = '<node pkg="rviz2" exec="rviz2"{}/>'
OFF, ON = (f'<arg name="rviz" default="{each}"/>' + RVIZ.format(' if="$(var rviz)"') for each in ("false", "true"))
INSTALL = "install(DIRECTORY launch meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"


def include(name: str, package: str = "my_pkg") -> str:
    return f'<include file="$(find-pkg-share {package})/launch/{name}.launch.xml"/>'


TOP = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="top">
  <xacro:arg name="model" default="{}"/>
  <xacro:include filename="$(find my_pkg)/urdf/$(arg model).urdf.xacro"/>
</robot>
"""
SHOW_TOP = NAME.replace("/r.", "/top.") + RVIZ.format("")


def opened(mesh: str = FOUND, other: str = "", top: str = "", /, **launches: str) -> Example:
    """A robot, the launch files of its package, and perhaps one of another package or a robot that includes it."""
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", INSTALL),
        "meshes/a.stl": "solid a\n",
        "urdf/r.urdf.xacro": ROBOT.format(mesh),
    }
    files |= {f"launch/{name}.launch.xml": f"<launch>{text}</launch>\n" for name, text in launches.items()}
    bad = {f"my_pkg/{path}": text for path, text in files.items()}
    if top:
        bad["my_pkg/urdf/top.urdf.xacro"] = TOP.format(top)
    if other:
        bad["other/package.xml"] = manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_cmake", name="other")
        bad["other/launch/o.launch.xml"] = f"<launch>{other}</launch>\n"
    return Example(on="", bad=bad, good={})


def made(example: Example) -> Example:
    """The same of a `.urdf`, which Gazebo opens without xacro."""
    plain = {
        path.replace(".xacro", ""): text.replace(".urdf.xacro", ".urdf")
        for path, text in example.bad.items()
        if isinstance(text, str)
    }
    return Example(on="", bad=plain, good={})


CASES = {
    "URD002": (
        opened(a=OPEN + GAZEBO),
        opened(a=OPEN + GAZEBO + OFF),
        opened(a=OPEN + GAZEBO + ON),
        opened(a=OPEN + RVIZ.format("")),
        opened(a=OPEN + '<executable cmd="rviz2 -d a.rviz"/>'),
        opened(a=OPEN + '<node pkg="moveit_ros_move_group" exec="move_group"/>'),
        opened(a=OPEN, b=include("a") + RVIZ.format("")),
        opened(a=OPEN + include("b"), b=RVIZ.format("")),
        opened(a=OPEN + GAZEBO, b=RVIZ.format("")),
        opened(a=OPEN + include("display", "urdf_launch")),
        opened(a=OPEN + include("gzserver", "gazebo_ros")),
        opened(RELATIVE, a=OPEN + GAZEBO),
        made(opened(BESIDE, a=CREATE)),
        made(opened(BESIDE, a=CREATE + RVIZ.format(""))),
        made(opened(RELATIVE, a=CREATE)),
        made(opened(BESIDE, a=CREATE.replace("create", "spawn_entity.py").replace("ros_gz_sim", "gazebo_ros"))),
        made(opened(BESIDE, a=CREATE, b=OPEN)),
        made(opened(BESIDE, OPEN, a=CREATE)),
        made(opened(BESIDE, a=CREATE + '<node pkg="robot_state_publisher" exec="robot_state_publisher"/>')),
        opened(FOUND, OPEN + GAZEBO),
        opened(FOUND, OPEN + RVIZ.format("")),
        opened(FOUND, include("a") + RVIZ.format(""), a=OPEN),
        opened(FOUND, RVIZ.format(""), a=OPEN + include("o", "other")),
        opened(FOUND, OPEN + include("a"), a=RVIZ.format("")),
        opened(a=NAME + GAZEBO, b=include("a") + RVIZ.format("")),
        opened(a=NAME + GAZEBO + include("c"), b=include("a") + RVIZ.format(""), c=PUBLISH),
        opened(a=NAME + GAZEBO + include("rsp", "others"), b=include("a") + RVIZ.format("")),
        opened(FOUND, NAME + '<node pkg="gazebo_ros" exec="spawn_entity.py"/>', a=RVIZ.format("")),
        opened(FOUND, NAME + GAZEBO + include("a"), a=RVIZ.format("")),
        opened(FOUND, "", "q", a=OPEN + GAZEBO, b=SHOW_TOP),
        opened(FOUND, "", "r", a=OPEN + GAZEBO, b=SHOW_TOP),
        opened(FOUND, "", "q", a=OPEN + GAZEBO, b=SHOW_TOP + '<let name="model" value="r"/>'),
    )
}
