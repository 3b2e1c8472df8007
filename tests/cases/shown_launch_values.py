"""Values of launch files that are nothing, text by mistake, too late or misspelt."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.launch import lch013_undefined_launch_name as lch013
from rospkg_cli.rules.launch import lch019_unknown_bridge_type as lch019

from .shown_launch import xml
from .shown_launch_calls import HEAD, NEEDED, python


def local(*lines: str, after: str = "") -> Example:
    body = "".join(f"    {line}\n" for line in lines)
    text = f"{HEAD}\n\ndef generate_launch_description():\n{body}    return LaunchDescription([])\n{after}"
    return Example(bad={"package.xml": lch013.NEEDED, "launch/a.launch.py": text}, good={})


EMPTY = xml(
    '<node pkg="p" exec=""/>',
    '<node pkg="p" exec=" "/>',
    '<node pkg=" " exec="e"/>',
    '<node pkg="$(var p)" exec="$(var e)"/>',
)
BARE = xml(
    '<arg name="x" default="1"/>',
    '<let name="a" value="(var x)"/>',
    '<let name="b" value="(var y)"/>',
    '<let name="c" value="$(var x) f(var x)"/>',
    '<include file="(find-pkg-share p)/launch/a.launch.xml"/>',
    '<include file="$(find-pkg-share p)/launch/b.launch.xml"/>',
    '<arg name="z" default="$(var x)" description="as (var x)"/>',
    '<log message="(var x)"/>',
)
DEFAULTS = python(
    "LogInfo(msg=['x', os.environ.get('X', 5)])",
    "LogInfo(msg=os.getenv('X', 1.5))",
    "LogInfo(msg=os.environ.get('X', 'y'))",
    "LogInfo(msg=os.environ.get('X'))",
    "LogInfo(msg=os.environ.get('X', None))",
    "ExecuteProcess(cmd=['ls', os.environ.get('X', 5)])",
    "Node(package='p', executable='e', arguments=['a', os.environ.get('X', default=5)])",
    "LogInfo(msg=str(os.environ.get('X', 5)))",
    "LogInfo(msg=os.environ.get(NAME, 5))",
    "Node(package='p', executable='e', arguments={'a', '-b'})",
    "Node(package='p', executable='e', arguments={'a'})",
    "Node(package='p', executable='e', arguments=('a', '-b'))",
)
LATE = (
    local("print(first)", "first = 1"),
    local("print(first)", "print(first)", "first: int = 1"),
    local("print([first for _ in range(3)], lambda: first)", "first = 1"),
    local("if unknown:", "    print(first)", "first = 1"),
    local("print(first)", "if unknown:", "    first = 1"),
    local("print(first)", "first = 1", "first = 2"),
    local("first = first", "print(first)"),
    local("print(first)", "first: int", "first = 1"),
    local("global first", "print(first)", "first = 1", after="first = 0\n"),
    local("def first():", "    return second", "second = 1", "print(first())"),
    local(after="def unused():\n    print(second)\n    second = 1\n"),
    local("print(os.path)", "import os.path"),
    local("print(a)", "for a in []:", "    pass"),
)


def included(*lines: str) -> Example:
    return xml('<include file="$(find-pkg-share nav2_bringup)/launch/b.launch.xml"/>', *lines)


UNSURE = (
    included('<arg name="rate" default="1"/>', '<log message="$(var rat)"/>'),
    included('<log message="$(var rat)"/>'),
    xml('<include file="$(var unknown)"/>', '<arg name="rate" default="1"/>', '<log message="$(var rat)"/>'),
    Example(
        bad={
            **included('<arg name="rate" default="1"/>', '<log message="$(var rat)"/>').bad,
            "launch/c.launch.xml": '<launch>\n  <arg name="rat"/>\n  <log message="$(var rat)"/>\n</launch>\n',
        },
        good={},
    ),
    xml('<arg name="rate" default="1"/>', "<group>", '<include file="$(find-pkg-share nav2_bringup)/b.launch.xml"/>',
        "</group>", '<log message="$(var rat)"/>'),
)  # fmt: skip
UNREAD = Example(
    bad={
        "package.xml": NEEDED,
        "launch/a.launch.py": f"{HEAD}\n\ndef generate_launch_description():\n    rate = LaunchConfiguration('rate')\n"
        "    speed = LaunchConfiguration('speed')\n    return LaunchDescription([DeclareLaunchArgument('rate'), "
        "DeclareLaunchArgument('speed'), LogInfo(msg=speed)])\n",
    },
    good={},
)
BRIDGE = Example(
    bad={
        "package.xml": manifest(lch019.NEEDED),
        "launch/a.launch.py": f"{HEAD}\n\ndef generate_launch_description():\n    return LaunchDescription([Node(\n"
        "        package='ros_gz_bridge', executable='parameter_bridge', arguments=[\n"
        + "".join(
            f"            {each},\n"
            for each in (
                "'/a@std_msgs/msg/String@gz.msgs.StringMsg'",
                "'/a@std_msg/msg/String@gz.msgs.StringMsg'",
                "'/a@std_msgs/msgs/String@gz.msgs.StringMsg'",
                "'/a@std_msgs/msg/Strin[gz.msgs.StringMsg'",
                "'/a@std_msgs/msg/SomethingElse]gz.msgs.StringMsg'",
                "'/a@sensor_msgs/LaserScn[gz.msgs.LaserScan'",
                "'/a@somebodys_msgs/msg/Strin[gz.msgs.StringMsg'",
                "'/a@my_srvs/srv/Strin'",
                "['/model/', a, '/odom@nav_msg/msg/Odometry[gz.msgs.Odometry']",
                "'--ros-args', '-r', 'user@example'",
            )
        )
        + "        ]),\n        Node(package='other', executable='e', arguments=['/a@std_msg/msg/String@x'])])\n",
    },
    good={},
)
LIBRARY = """\
my_pkg:
  a:
    type: double
    validation:
      {}
"""


def validator(text: str) -> Example:
    return Example(
        on="ament_cmake",
        bad={
            "CMakeLists.txt": CMAKE.replace(
                "ament_package",
                "find_package(generate_parameter_library REQUIRED)\n"
                "generate_parameter_library(parameters src/parameters.yaml)\nament_package",
            ),
            "package.xml": manifest("  <depend>generate_parameter_library</depend>\n", "ament_cmake"),
            "src/parameters.yaml": LIBRARY.format(text),
        },
        good={},
    )


def block(yaml: str, *nodes: str, **more: str) -> Example:
    launch = "<launch>\n" + "".join(f"  {node}\n" for node in nodes) + "</launch>\n"
    install = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})"
    return Example(
        on="config",
        bad={
            "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace("ament_package()", f"{install}\nament_package()"),
            "launch/robot.launch.xml": launch,
            "config/robot.yaml": yaml,
            **more,
        },
        good={},
    )


def node(name: str, more: str = "") -> str:
    return (
        f'<node pkg="turtlesim" exec="turtlesim_node"{name}{more}>'
        '<param from="$(find-pkg-share my_pkg)/config/robot.yaml"/></node>'
    )


ONE, TWO = "elsewhere:\n  ros__parameters:\n    a: 1\n", "somewhere:\n  ros__parameters:\n    a: 1\n"
NAMED = ' name="turtle"'
BLOCKS = (
    block(ONE, node(NAMED)),
    block(ONE + TWO, node(NAMED)),
    block(ONE, node(NAMED), node("")),
    block(ONE, node(NAMED), node(' name="$(var x)"')),
    block(ONE, node(NAMED), node(' name="other"')),
    block(ONE, node(NAMED, ' if="$(var x)"')),
    block(ONE, node(NAMED), '<node pkg="turtlesim" exec="turtlesim_node" name="elsewhere"/>'),
    block(ONE, node(NAMED), '<include file="$(find-pkg-share nav2_bringup)/launch/b.launch.xml"/>'),
    block(ONE, node(NAMED), **{"launch/b.launch.xml": '<launch>\n  <let name="f" value="robot.yaml"/>\n</launch>\n'}),
)
BRIDGE_OFF = Example(
    bad={
        "package.xml": NEEDED,
        "launch/a.launch.xml": '<launch>\n  <arg name="sim" default="false"/>\n  <node pkg="ros_gz_bridge" '
        'exec="parameter_bridge" args="/a@std_msg/msg/String@gz.msgs.StringMsg" if="$(var sim)"/>\n</launch>\n',
    },
    good={},
)
DROPPED = Example(
    bad={
        "package.xml": NEEDED,
        "launch/a.launch.py": "import os\n\nfrom launch import LaunchDescription\nfrom launch.actions import LogInfo\n"
        "\n\ndef generate_launch_description():\n    return LaunchDescription([LogInfo(msg=os.path.join(os.getcwd(), "
        "'/tmp/a.txt'))])\n",
    },
    good={},
)
CASES = {
    "LCH002": (EMPTY,),
    "LCH007": (BARE,),
    "LCH008": UNSURE,
    "LCH013": LATE,
    "LCH014": (DEFAULTS,),
    "LCH017": (UNREAD,),
    "LCH019": (BRIDGE, BRIDGE_OFF),
    "LCH021": (DROPPED,),
    "PRM003": BLOCKS,
    "PRM009": tuple(
        map(
            validator,
            (
                "bounds<>: [0.0, 1.0]", "bounds<>: [0.0]", "gt<>: 0.0", "one_of<>: [1.0, 2.0]", "one_of<>: [[1.0]]",
                "subset_of<>: 1.0", "not_empty<>: null", "not_empty<>: []", "not_empty<>: [1]", "unique<>: true",
                "size_gt<>:", "my::own: 5", "lower_element_bounds<>: []", "one_of<>: []",
            ),
        )
    ),
}  # fmt: skip
