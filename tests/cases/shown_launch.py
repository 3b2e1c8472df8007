"""Sentences and silences of the rules for launch files: entities, expressions, names, files."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, setup_py
from rospkg_cli.rules.launch import lch013_undefined_launch_name as lch013

from .shown_launch_calls import HEAD, NEEDED, node, python

RETURNS = "def generate_launch_description():\n    return LaunchDescription()\n"


def xml(*lines: str) -> Example:
    text = "<launch>\n" + "".join(f"  {line}\n" for line in lines) + "</launch>\n"
    return Example(bad={"package.xml": NEEDED, "launch/a.launch.xml": text}, good={})


def names(text: str) -> Example:
    return Example(bad={"package.xml": lch013.NEEDED, "launch/a.launch.py": text}, good={})


def broken(*lines: str) -> Example:
    """A Python launch file with functions that use names."""
    body = "".join(f"    {line}\n" for line in lines)
    return names(
        f"{HEAD}def setup(context):\n{body}\n\ndef generate_launch_description():\n    setup(None)\n"
        "    return LaunchDescription()\n"
    )


ENTITIES = xml(
    "<arg/>",
    '<arg name="a" defalt="x"/>',
    '<arg name="b" default="x" value="y"/>',
    '<arg name="c"><choice value="x"/><choice valeu="x"/><option name="x"/></arg>',
    '<node pkg="p" exec="e" if="true" unless="false"/>',
    '<node pkg="p" type="e"/>',
    '<node package="p" exec="e"/>',
    '<node pkg="p"/>',
    '<node pkg="p" exec="e"><param name="x"/><param value="y"/><parm name="z" value="1"/></node>',
    '<node pkg="p" exec="e"><remap from="x"/><remap from="x" to="y"/><env name="X" value="y"/><group/></node>',
    '<node pkg="p" exec="e"><param name="x" value="1"><param name="y" value="2"/><node/></param></node>',
    '<nodee pkg="p" exec="e"/>',
    '<something_else a="b"/>',
    '<param name="a" value="b"/>',
    '<group scoped="true" forwardng="x"><log message="x"/><lgo message="x"/><arg name="d"/></group>',
    '<include file="x"><arg name="a" value="1"/><arg name="a" default="1"/><arg/><let name="a" value="b"/></include>',
    '<let name="x"/>',
    '<set_env name="A"/>',
    '<push_ros_namespace namespace="x"/>',
    '<push-ros-namespace namespace="x"/>',
    '<log message="x" level="INFO"/>',
    '<executable cmd="ls" outptu="screen"/>',
    '<timer period="5"><log message="x"/></timer>',
    '<timer><log message="x"/></timer>',
    '<node_container pkg="p" exec="e" name="c" namespace=""><composable_node pkg="p" plugin="q"/></node_container>',
    '<load_composable_node target="c"><composable_node pkg="p"/><node pkg="p" exec="e"/></load_composable_node>',
)
REFUSED = xml(
    '<log message="$(vra a)"/>',
    '<log message="$(var)"/>',
    '<log message="$(var a b c)"/>',
    '<log message="$(dirname x)"/>',
    '<log message="$(env X y)"/>',
    '<log message="$(env X y z)"/>',
    '<log message="$(something_else x)"/>',
    '<log message="$(find-pkg-shar my_pkg)"/>',
    '<log message="$(find-pkg-share)"/>',
    '<log message="$(exec-in-pkg x)"/>',
    '<log message="$(command)"/>',
    '<log message="$(var a"/>',
    '<log message="$(not x y)"/>',
    '<log message="$(and x)"/>',
    '<log message="$(if x y z a)"/>',
)
QUOTED = xml(
    '<arg name="speed" default="1"/>',
    '<arg name="used" default="1"/>',
    '<node pkg="p" exec="e">',
    '<param name="speed" value="speed"/>',
    '<param name="used" value="used"/>',
    '<param name="other" value="other"/>',
    '<param name="more" value="speed"/>',
    '<param name="used" value="$(var used)"/>',
    "</node>",
)
YAML = """\
launch:
- arg:
    name: a
- nod:
    pkg: p
    exec: e
- node:
    pkg: p
- grop: []
- group:
  - lgo:
"""
EXPRESSIONS = xml(
    '<arg name="flag" default="true"/>',
    '<arg name="number" default="5"/>',
    '<arg name="none"/>',
    *(
        f'<let name="x{number}" value="$(eval &quot;{each}&quot;)"/>'
        for number, each in enumerate(
            (
                "1 +",
                "$(var flag) and 1",
                "not $(var none)",
                "$(var number) * 2",
                "'$(var flag)' == 'true'",
                "true",
                "false",
                "nothing + 1",
                "[x for x in (1, 2)]",
                "pi * 2",
                "math.pi",
                "lambda x: x",
                "len('x')",
                "$(var none) nothing",
                "$(eval '1 +')",
                "$(something_else x) +",
                "'$(env X)' == 'x'",
                "$(var flag) $(var flag)",
                "x := 5",
            )
        )
    ),
    '<let name="y" value="$(eval)"/>',
)
IN_PYTHON = python(
    "DeclareLaunchArgument('flag', default_value='true')",
    *(
        f"LogInfo(msg='x', condition=IfCondition(PythonExpression({each})))"
        for each in (
            "['not ', LaunchConfiguration('flag')]",
            "['1 +']",
            "'true'",
            "[\"'\", LaunchConfiguration('flag'), \"'\"]",
            "['not ', unknown]",
            "unknown",
            "[LaunchConfiguration('none'), ' and nothing']",
            "['False']",
        )
    ),
)
OLD = xml(
    '<param name="a" value="b"/>',
    '<rosparam file="x"/>',
    '<machine name="x"/>',
    '<remap from="a" to="b"/>',
    '<env name="A" value="b"/>',
    '<node pkg="p" exec="e"><rosparam command="load" file="x"/><machine name="x"/></node>',
    '<group ns="x"><param name="a" value="b"/><test test-name="x"/></group>',
    '<log message="$(find my_pkg)"/>',
    '<log message="$(arg a)"/>',
    '<log message="$(optenv A b)"/>',
    '<log message="$(dirname)"/>',
    '<log message="$( find my_pkg)"/>',
    '<arg name="a" default="$(anon a)"/>',
    '<master auto="start"/>',
)
REMOVED = python(
    *(
        f"{name}({arguments})"
        for name, arguments in (
            ("Node", "node_executable='e', package='p'"),
            ("Node", "package='p', executable='e', node_name='x', name='y'"),
            ("Node", "package='p', executable='e', node_namespace='x'"),
            ("ComposableNode", "package='p', node_plugin='x'"),
            ("LogInfo", "msg='x', node_name='x'"),
            ("Node", "package='p', executable='e', **{'node_name': 'x'}"),
        )
    ),
)
LATER = Example(bad={**REMOVED.bad, "README.md": "For Jazzy.\n"}, good={})
REMOVED_XML = xml(
    '<node pkg="p" type="e"/>',
    '<node pkg="p" type="e" exec="f"/>',
    '<executable cmd="x" type="e"/>',
    '<group><node pkg="p" type="e"/></group>',
)
ASKS = python(
    "Node(package='p', executable='e', node_name='x')",
    *(
        f"Node(package='p', executable='e', node_name='x') if {each} else LogInfo(msg='x')"
        for each in ("os.environ['ROS_DISTRO'] == 'foxy'",)
    ),
)
UNDEFINED = broken(
    "first = nothing",
    "[x for x in y]",
    "[z for z in (1, 2)] + z1",
    "lambda q, *r, s=t, **u: q + r + s + u + v",
    "def inner(w: W, /, *, x=X) -> Y: return w + x + inner",
    "@decorated",
    "class Inner(Base, metaclass=Meta):",
    "    field: Annotated = fields",
    "    def method(self): return self, __class__, field, super",
    "    more = __qualname__, field",
    "try:",
    "    caught",
    "except NameError:",
    "    handled",
    "try:",
    "    not_caught",
    "except ValueError as error:",
    "    error, missed",
    "try:",
    "    everything",
    "except (TypeError, Exception):",
    "    pass",
    "else:",
    "    after",
    "finally:",
    "    last",
    "if (walrus := 5): walrus",
    "match first:",
    "    case [head, *tail]: head, tail, guarded",
    "    case {'x': value, **others}: value, others",
    "    case str() as named if condition: named",
    "global everywhere",
    "everywhere = 5",
    "with open('x') as opened, unopened: opened",
    "for item in items: item",
    "del item, __file__, print",
    "import os.path as aliased; aliased",
    "LogInof(msg='x'), Nod(package='p'), AndSubstitution(a, b), contxt",
    "{k: w1 for k, w1 in pairs if k}, {s1 for s1 in sets}, (g for g in generators)",
    "nothing",
)
QUIET = tuple(
    names(f"{HEAD}{line}\n\n\ndef generate_launch_description():\n    nothing\n    return LaunchDescription()\n")
    for line in (
        "from os.path import *",
        "exec('nothing = 5')",
        "globals()['nothing'] = 5",
        "locals()",
        "eval('1')",
        "try:\n    from os.path import *\nexcept ImportError:\n    pass",
        "nothing = 5",
        "import nothing",
    )
)
IMPORTS = names(
    "from launch import LaunchDescription, LogInfo, Lunch\nfrom launch.actions import Node, LogInof, TimerAction\n"
    "from launch_ros.actions import Node as N, LaunchConfiguration\nfrom launch.substitutions import FindPackageShare\n"
    "from launch_ros.descriptions import something_else\nfrom launch.event_handlers import OnProcessExt\n"
    "\n\ndef generate_launch_description():\n    return LaunchDescription()\n"
)
SHARE = "get_package_share_directory('my_pkg')"
REFERENCES = python(
    *(
        f"IncludeLaunchDescription({each})"
        for each in (
            f"{SHARE} + '/launch/nothing.launch.py'",
            f"os.path.join({SHARE}, 'launch', 'othre.launch.py')",
            f"{SHARE} + '/launch/other.launch.py'",
            f"{SHARE} + 'launch/other.launch.py'",
            f"{SHARE} + '/launch/nothing.launch.py'",
            "FindPackageShare('nav2_bringup')",
            "unknown",
        )
    ),
    *node(f"parameters=[{SHARE} + '/config/nothing.yaml']", f"arguments=['-d', {SHARE} + '/rviz/nothing.rviz']"),
    f"DeclareLaunchArgument('map', default_value={SHARE} + '/maps/nothing.yaml')",
)
ALSO = Example(
    bad={
        **REFERENCES.bad,
        "launch/other.launch.py": "from launch import LaunchDescription\n\n\n"
        "def generate_launch_description():\n    return LaunchDescription()\n",
    },
    good={},
)
TOO_LITTLE = CMAKE.replace(
    "ament_package",
    "install(FILES launch/a.launch.xml DESTINATION share/${PROJECT_NAME}/launch)\n"
    "install(FILES launch/b.launch.xml DESTINATION share/${PROJECT_NAME}/other)\nament_package",
)
ELSEWHERE = Example(
    bad={
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": TOO_LITTLE,
        "launch/a.launch.xml": '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/b.launch.xml"/>\n'
        '  <include file="$(dirname)/c.launch.xml"/>\n  <include file="$(dirname)/d.launch.xml"/>\n'
        '  <include file="$(find-pkg-share my_pkg)/launch/c.launch.xml"/>\n'
        '  <include file="$(find-pkg-share my_pkg)/launch/c.launch.xml"/>\n</launch>\n',
        "launch/b.launch.xml": "<launch>\n</launch>\n",
        "launch/c.launch.xml": "<launch>\n</launch>\n",
    },
    good={},
    on="ament_cmake",
)
LAUNCH_FOLDER = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"

READ = '  <log message="$(var file)"/>\n</launch>'
SHARED = Example(
    bad={
        **ELSEWHERE.bad,
        "CMakeLists.txt": CMAKE.replace("ament_package", "install(DIRECTORY launch DESTINATION share)\nament_package"),
        "launch/d.launch.xml": '<launch>\n  <arg name="file" default="$(find-pkg-share my_pkg)/launch/b.launch.xml"/>\n'
        + READ
        + "\n",
    },
    good={},
    on="ament_cmake",
)
MODULES = Example(
    bad={
        "setup.py": setup_py().replace(
            "    license=",
            "    entry_points={'console_scripts': ['talk = my_pkg.arm_node:main', 'wave = my_pkg.arm:wave', "
            "'rest = my_pkg.arm:rest']},\n    license=",
        ),
        "my_pkg/arm_node.py": "def main():\n    pass\n",
        "my_pkg/arm.py": "def wave():\n    pass\n\n\ndef rest():\n    pass\n",
        "start.sh": "ros2 launch launch/a.launch.xml\n",
        "launch/a.launch.xml": "<launch>\n"
        + "".join(f'  <node pkg="my_pkg" exec="{name}"/>\n' for name in ("arm_node", "arm_node.py", "arm", "leg"))
        + "</launch>\n",
    },
    good={},
)

ROS1_PARAM = '<launch>\n  <param name="speed" value="1.0"/>\n</launch>\n'
CATKIN = "  <buildtool_depend>catkin</buildtool_depend>\n"


def for_ros1(body: str, build_type: str = "catkin") -> Example:
    text = manifest(body, build_type)
    return Example(bad={"package.xml": text, "launch/a.launch": ROS1_PARAM}, good={}, on="")


ROS1_NODE = '<launch>\n  <node pkg="my_pkg" type="a" name="a" args="$(arg rate) $(find my_pkg)"/>\n</launch>\n'
ROS1_PACKAGES = (
    for_ros1(CATKIN),
    for_ros1("  <depend>catkin</depend>\n"),
    for_ros1(CATKIN + "  <buildtool_depend>ament_cmake</buildtool_depend>\n"),
    for_ros1(CATKIN, "ament_cmake"),
    *(
        Example(
            on="ament_cmake",
            good={},
            bad={
                "launch/a.launch": ROS1_NODE,
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package",
                    f"{more}install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})\nament_package",
                ),
            },
        )
        for more in ("", "if(DEFINED CATKIN_DEVEL_PREFIX)\n  catkin_package()\nendif()\n")
    ),
    Example(
        on="ament_cmake",
        good={},
        bad={
            **{f"launch/{name}": ROS1_NODE for name in ("b.launch", "sub/c.launch", "a.launch", "a_ros1.launch")},
            "launch/d.launch": "<launch>\n</launch>\n",
            "CMakeLists.txt": CMAKE.replace(
                "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
            ),
        },
    ),
)


def of_distributions(lines: str) -> Example:
    """A package that installs one of two folders of launch files, or both."""
    folders = [f"install(DIRECTORY launch/{each} DESTINATION share/my_pkg/launch)" for each in ("humble", "jazzy")]
    text = CMAKE.replace(
        "ament_package", f"{lines.replace('{X}', '<X>').format(*folders).replace('<X>', '{X}')}\nament_package"
    )
    files = {f"launch/{each}/a.launch.xml": "<launch/>\n" for each in ("humble", "jazzy")}
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="ament_cmake")


CASES = {
    "LCH002": (MODULES,),
    "LCH003": (ALSO, ELSEWHERE),
    "LCH004": (ALSO, ELSEWHERE, SHARED),
    "LCH005": (REMOVED, REMOVED_XML, ASKS, LATER),
    "LCH006": (OLD, *ROS1_PACKAGES),
    "LCH007": (
        ENTITIES, REFUSED, QUOTED, EXPRESSIONS, IN_PYTHON,
        Example(bad={"package.xml": NEEDED, "launch/a.launch.yaml": YAML}, good={}),
    ),
    "LCH008": (
        xml('<log message="$(arg rate)"/>', '<node pkg="p" type="e" name="n" args="$(arg rate) $(find p)"/>'),
        xml('<log message="$(var rate)"/>', '<node pkg="p" type="e" name="n" args="$(arg rate) $(find p)"/>'),
        xml('<log message="$(var rate)"/>', '<lgo message="x"/>'),
        xml('<log message="$(var rate) $(var map)"/>'),
        xml('<log message="$(var rate) $(var map)"/>', '<arg name="x" default="1"/>', '<log message="$(var x)"/>'),
        xml('<log message="$(var rate)"/>', '<include file="$(var unknown)"/>'),
        xml('<let name="rate" value="1"/>', '<log message="$(var rate) $(var log_dir) $(var other)"/>'),
        xml('<group>', '<arg name="rate" default="1"/>', '</group>', '<log message="$(var rate)"/>'),
        xml('<log message="$(var rate 1) $(var rate)"/>', '<arg name="rate" default="1"/>'),
        names(f"{HEAD}x = LaunchConfiguration('rate')\n"),
        names(f"{HEAD}{RETURNS}".replace("()", "([LogInfo(msg=LaunchConfiguration('rate'))] + unknown)")),
        *(Example(bad={"package.xml": NEEDED, path: '<launch><log message="$(var rate)"/></launch>\n'}, good={})
          for path in ("test/a.launch.xml", "launch/include/a.launch.xml")),
    ),
    "LCH012": (
        *(Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package", f"{LAUNCH_FOLDER}\nament_package"),
                       **{f"launch/{number}/a.launch.xml": "<launch/>\n" for number in range(count)}},
                  good={}, on="ament_cmake")
          for count in (3, 4)),
        of_distributions("if($ENV{X})\n  {}\nelse()\n  {}\nendif()"),
        of_distributions("if($ENV{X})\n  {}\nendif()\n{}"),
    ),
    "LCH013": (UNDEFINED, IMPORTS, *QUIET),
}  # fmt: skip
