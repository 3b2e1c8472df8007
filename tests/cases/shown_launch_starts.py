"""Sentences and silences about what a launch file starts, adds and opens."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_PY_FOR_ALL, Example, manifest, scripts, setup_py
from rospkg_cli.rules.launch import lch002_unknown_executable as lch002
from rospkg_cli.rules.launch import lch015_include_argument_mismatch as lch015

from .shown_launch import xml
from .shown_launch_calls import HEAD, node, python

SHARE = "from ament_index_python.packages import get_package_share_path\n"


def started(*lines: str, name: str = "a.launch.xml", **files: str) -> Example:
    text = "<launch>\n" + "".join(f"  {line}\n" for line in lines) + "</launch>\n"
    return Example(bad={**lch002.FILES, "launch/a.launch.xml": None, f"launch/{name}": text, **files}, good={})


WITHOUT_PACKAGE = started(
    '<node exec="talker"/>',
    '<node exec="python3"/>',
    '<node exec="$(var x)"/>',
    '<node exec="/opt/talker"/>',
    '<executable cmd="talker"/>',
    '<node_container exec="talker" name="c" namespace=""/>',
    '<lifecycle_node exec="talker" name="c" namespace=""/>',
    '<node exec="talker" if="false"/>',
    '<composable_node exec="talker" plugin="x" name="c"/>',
)
OPEN_CALL = Example(
    bad={
        **lch002.FILES,
        "launch/a.launch.xml": None,
        "launch/a.launch.py": f"{HEAD}def generate_launch_description():\n    rest = {{'package': unknown}}\n"
        "    node = Node(executable='talker')\n"
        "    return LaunchDescription([node, Node(executable='talker', **unknown), Node(executable='talker')])\n",
    },
    good={},
)
UNUSED_TEST = Example(
    bad={
        **lch002.FILES,
        "launch/a.launch.xml": None,
        "setup.py": None,
        "setup.cfg": None,
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", "install(PROGRAMS run DESTINATION lib/my_pkg)\nament_package"),
        "run": "#!/bin/sh\n",
        "test/a.launch.xml": '<launch>\n  <node exec="run"/>\n</launch>\n',
        "start.sh": "ros2 launch launch/b.launch.xml\n",
        "launch/b.launch.xml": '<launch>\n  <node exec="run"/>\n</launch>\n',
    },
    good={},
    on="ament_cmake",
)
ON_PATH = Example(
    bad={
        **lch002.FILES,
        "launch/a.launch.xml": '<launch>\n  <node exec="talker"/>\n</launch>\n',
        "setup.cfg": "[develop]\nscript_dir=$base/bin\n[install]\ninstall_scripts=$base/bin\n",
    },
    good={},
)
PARAMETERS = xml(
    '<node pkg="p" exec="e"><param name="rate"/></node>',
    '<node pkg="p" exec="e"><param name="rate" value=""/></node>',
    '<node pkg="p" exec="e"><param name="rate" vale="1"/></node>',
    '<node pkg="p" exec="e"><param name="a"><param name="b"/></param></node>',
    '<node pkg="p" exec="e"><param name="a"><param name="b" value="1"/></param></node>',
    '<node pkg="p" exec="e"><param name="a"><param from="b"/></param></node>',
    '<node pkg="p" exec="e"><param/></node>',
    '<node pkg="p" exec="e"><param value="1"/></node>',
    '<node pkg="p" exec="e"><param from="a.yaml"/></node>',
    '<node pkg="p" exec="e"><param name="a" from="a.yaml"/></node>',
    '<node pkg="p" exec="e"><param name="a" value="1"><param name="b" value="1"/></param></node>',
)
SINGLE = python(
    *node(
        "parameters=ParameterFile(a)",
        "parameters=[ParameterFile(a)]",
        "parameters=RewrittenYaml(source_file=a, param_rewrites={})",
        "parameters=ReplaceString(source_file=a, replacements={})",
        "parameters=configs.to_dict()",
        "parameters=configs.to_list()",
        "parameters=one_of",
        "parameters=mixed",
        "parameters=unknown",
    ),
    before="from nav2_common.launch import ReplaceString, RewrittenYaml\n"
    "from moveit_configs_utils import MoveItConfigsBuilder\n"
    "configs = MoveItConfigsBuilder('robot')\n"
    "if unknown:\n    one_of, mixed = 'a.yaml', 'a.yaml'\nelse:\n    one_of, mixed = 'b.yaml', ['b.yaml']\n",
)


def beside(text: str) -> Example:
    """A launch file that makes what it never adds, and another one of the package."""
    one = unused("node = Node(package='p', executable='e')", "load = ExecuteProcess(cmd=['ros2', 'load', 'joint'])")
    return Example(bad={**one.bad, "launch/b.launch.xml": text}, good={})


def unused(*lines: str, before: str = "", returned: str = "[first]", **files: str) -> Example:
    body = "".join(f"    {line}\n" for line in ("first = LogInfo(msg='up')", *lines))
    text = f"{HEAD}{before}\n\ndef generate_launch_description():\n{body}    return LaunchDescription({returned})\n"
    named = {f"{name}.py": each for name, each in files.items()}
    return Example(bad={"package.xml": manifest(), "launch/a.launch.py": text, **named}, good={})


ACTIONS = unused(
    "node = Node(package='p', executable='e')",
    "more = IncludeLaunchDescription(source)",
    "wait = TimerAction(period=1.0, actions=[])",
    "nodes = [Node(package='p', executable='e')]",
    "_node = Node(package='p', executable='e')",
    "read = Node(package='p', executable='e')",
    "print(read)",
    "LogInfo(msg='lost')",
    "print('lost')",
    "noted = Node(package='p', executable='e')",
    "# noted is added once it works",
    "quoted = Node(package='p', executable='e')",
    "'''quoted is old'''",
    "condition = IfCondition(a)",
    "rate = DeclareLaunchArgument('rate', default_value='1')",
    "speed = DeclareLaunchArgument('speed')",
    "LogInfo(msg=LaunchConfiguration('speed'))",
    returned="[first, LogInfo(msg=[LaunchConfiguration('speed'), LaunchConfiguration('rate', default='1')])]",
)
LOOKUPS = (
    "    a = context.launch_configurations['frist']\n"
    "    b = context.launch_configurations.get('secnod')\n"
    "    c = 'thrid' in context.launch_configurations\n"
    "    if a:\n        d = context.launch_configurations['fuorth']\n"
    "    e = [context.launch_configurations['fifht'] for _ in b]\n"
)


def looked_up(more: str = "") -> Example:
    return python(
        "DeclareLaunchArgument('first')",
        "OpaqueFunction(function=setup)",
        before=f"\n\ndef setup(context):\n{LOOKUPS}{more}    return []\n",
    )


TAKES = "DeclareLaunchArgument('rate', default_value='1'), LogInfo(msg=LaunchConfiguration('rate'))"
OTHER = f"{HEAD}\n\ndef generate_launch_description():\n    return LaunchDescription([{TAKES}])\n"
GIVEN = ", launch_arguments={'rat': '1'}.items())"


def including(*paths: str) -> Example:
    text = "".join(f"        IncludeLaunchDescription(PythonLaunchDescriptionSource({p}){GIVEN},\n" for p in paths)
    head = f"{HEAD}{SHARE}from launch.launch_description_sources import PythonLaunchDescriptionSource\n"
    body = (
        "def generate_launch_description():\n    share = get_package_share_path('my_pkg')\n"
        f"    return LaunchDescription([\n{text}    ])\n"
    )
    return Example(
        bad={
            "setup.py": SETUP_PY_FOR_ALL,
            "package.xml": manifest(),
            "launch/b.launch.py": OTHER,
            "launch/a.launch.py": f"{head}\n\n{body}",
        },
        good={},
    )


PATHS = including(
    "share / 'launch' / 'b.launch.py'",
    "str(share.joinpath('launch', 'b.launch.py').resolve())",
    "os.path.join(os.path.realpath(get_package_share_directory('my_pkg')), 'launch', 'b.launch.py')",
    "os.path.abspath(get_package_share_directory('my_pkg') + '/launch/b.launch.py')",
    "str(share.with_name('launch').joinpath('b.launch.py'))",
    "share.joinpath(unknown)",
)
ABSENT = including(
    "share / 'launch' / 'record.launch.py'",
    "str(share.joinpath('launch', 'c.launch.py').absolute())",
    "os.path.normpath(get_package_share_directory('my_pkg') + '/launch/d.launch.py')",
    "os.path.realpath('launch/e.launch.py')",
    "get_package_share_directory('nav2_bringup') + '/launch/b.launch.py.py'",
    "get_package_share_directory('nav2_bringup') + '/launch/b.launch.py.launch.py'",
    "get_package_share_directory('nav2_bringup') + '/launch/b.launch.py'",
    "get_package_share_directory('my_pkg') + '/launch/b.launch.py.py'",
)
RELATIVE = Example(
    bad={
        **lch002.FILES,
        "config/a.yaml": "/**:\n  ros__parameters:\n    rate: 1.0\n",
        "launch/a.launch.xml": "<launch>\n"
        '  <arg name="file" default="a.yaml"/>\n'
        '  <arg name="folder" default="config/a.yaml"/>\n'
        '  <arg name="other" default="b.yaml"/>\n'
        '  <arg name="share" default="$(find-pkg-share my_pkg)/config/a.yaml"/>\n'
        '  <node pkg="my_pkg" exec="talker"><param from="$(var file)"/><param from="$(var file)"/></node>\n'
        '  <node pkg="my_pkg" exec="talker"><param from="$(var folder)"/><param from="$(var share)"/></node>\n'
        '  <node pkg="my_pkg" exec="talker"><param from="config/$(var file)"/><param from="$(var other)"/></node>\n'
        '  <node pkg="my_pkg" exec="talker"><param from="config/a.yaml"/><param from="fig/a.yaml"/></node>\n'
        '  <node pkg="my_pkg" exec="talker" if="false"><param from="a.yaml"/><param from="/config/a.yaml"/></node>\n'
        "</launch>\n",
    },
    good={},
)

UNKNOWN_INSIDE = Example(
    bad={
        **lch015.FILES,
        "launch/arm.launch.xml": lch015.ARM.replace(
            "</launch>", '  <include file="$(find-pkg-share elsewhere)/launch/a.launch.xml"/>\n</launch>'
        ),
        "launch/robot.launch.xml": lch015.GIVEN.replace('"speed"', '"speeed"').replace("«", "").replace("»", ""),
    },
    good={},
)


AS_BY_DEFAULT = Example(bad={**lch015.FILES, "launch/robot.launch.xml": lch015.GIVEN.replace("2.0", "1.0")}, good={})
LEFT_OVER = Example(bad={**lch015.FILES, "launch/robot.launch.xml": lch015.GIVEN.replace("«ratee»", "world")}, good={})


OTHERS = (
    ("config_mpc_fname",),
    ("config_mpc_fname", "config_robot_fname"),
    ("config_mpc_fname", "config_robot_fname", "config_arm_fname", "config_leg_fname"),
    ("config_mpc_fname", "config_robot_fname", "config_torso_fname", "config_sound_fname"),
    ("config_file_names", "config_robot_fname"),
)


def beside_others(declared: tuple[str, ...]) -> Example:
    """An argument that is given under another name, near to some that are declared."""
    lines = "".join(f'  <arg name="{each}" default="a"/><let name="a" value="$(var {each})"/>\n' for each in declared)
    given = lch015.GIVEN.replace("«ratee»", "config_file_name")
    arm = lch015.ARM.replace("</launch>", f"{lines}</launch>")
    return Example(bad={**lch015.FILES, "launch/arm.launch.xml": arm, "launch/robot.launch.xml": given}, good={})


def beside_a_macro(*names: str) -> Example:
    """A CMake package whose programs and files are not all known: what is named is a slip, or may be there."""
    lines = "".join(f'  <node pkg="my_pkg" exec="{name}"/>\n' for name in names)
    lines += "".join(f'  <include file="$(find-pkg-share my_pkg)/launch/{name}.launch.xml"/>\n' for name in names)
    macro = "someones_install_macro(config)\ninstall(PROGRAMS arm_driver DESTINATION lib/my_pkg)\n"
    return Example(
        bad={
            "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace(
                "ament_package", f"{macro}install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
            ),
            "arm_driver": "#!/bin/sh\n",
            "launch/arm_driver.launch.xml": "<launch/>\n",
            "launch/a.launch.xml": f"<launch>\n{lines}</launch>\n",
        },
        good={},
        on="ament_cmake",
    )


SLIPS = beside_a_macro("arm_drievr", "arm_drivers", "base_driver", "arm_driver")

CASES = {
    "LCH002": (WITHOUT_PACKAGE, OPEN_CALL, UNUSED_TEST, ON_PATH, SLIPS),
    "LCH003": (
        SLIPS,
        ABSENT,
        RELATIVE,
        *(
            including("share / 'urdf' / 'arm.urdf'", made)
            for made in ("xacro.open_output(share / 'urdf' / 'arm.urdf')", "xacro.process(share / 'urdf' / 'arm.urdf')")
        ),
    ),
    "LCH007": (PARAMETERS,),
    "LCH008": (
        looked_up(),
        looked_up("    context.launch_configurations['new'] = '1'\n"),
        looked_up("    context.launch_configurations.update(unknown)\n"),
    ),
    "LCH014": (SINGLE,),
    "LCH015": (PATHS, UNKNOWN_INSIDE, LEFT_OVER, *map(beside_others, OTHERS), AS_BY_DEFAULT),
    "LCH018": (
        ACTIONS,
        unused("node = Node(package='my_pkg', executable='e')", "more = Node(package='my_pkg', executable=first)"),
        unused(
            "node = Node(package='my_pkg', executable='e')",
            setup="from setuptools import setup\nfrom x import entries\n\nsetup(entry_points=entries())\n",
        ),
        unused("node = Node(package='my_pkg', executable='e')", setup=setup_py(scripts("e = my_pkg:main"))),
        *(
            unused(
                f"node = Node(package='p', executable='e'{mine})",
                f"Node(package='p', executable='e'{other})",
                f"more = Node(package='p', executable='e'{other})",
                returned="[first, more]",
            )
            for mine, other in (
                ("", ""),
                (", name='a'", ""),
                (", name='a'", ", name='a'"),
                (", name='a'", ", name='b'"),
                (", arguments=['1']", ", arguments=['1']"),
                (", arguments=['1']", ", arguments=['2']"),
                (", arguments=['1']", ", arguments=[first]"),
            )
        ),
        *(
            beside(text)
            for text in (
                '<launch>\n  <node pkg="p" exec="e"/>\n</launch>\n',
                '<launch>\n  <node pkg="p" exec="f"/>\n  <executable cmd="ros2 control load joint"/>\n</launch>\n',
            )
        ),
        unused(
            "node = ExecuteProcess(cmd=['ros2', 'control', 'load', 'joint'])",
            "for each in ['arm', 'joint']:",
            "    spawn(each)",
        ),
        unused("node = ExecuteProcess(cmd=['ros2', 'control', 'load', 'joint'])"),
        unused("node = ExecuteProcess(cmd=[])"),
        unused("node = Node(package='p', executable='e')", "print(locals())"),
        unused("node = Node(package='p', executable='e')", before="if __name__ == 'x':\n    print(1)\n"),
    ),
}
