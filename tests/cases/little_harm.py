"""Levels of what does harm where something else is there as well: a build without links, entry points, launch files."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py
from rospkg_cli.rules.params import prm001_missing_ros_parameters as prm001
from rospkg_cli.rules.setup import set105_entry_point_not_installed as set105
from rospkg_cli.rules.setup import set302_package_not_installed as set302

from .setups import OTHER_NAME, python

INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY config DESTINATION share/${PROJECT_NAME})\nament_package")
WRONG = prm001.GOOD.replace("ros__parameters", "ros_parameters", 1)
EMPTY_LIST = "limits:\n  ros__parameters:\n    limits: []\n"
LIST = "limits:\n  ros__parameters:\n    limits: [1, 2.5]\n"
UNSET = "talker:\n  ros__parameters:\n    rate:\n    depth: 5\n"
MAIN = "def main():\n    print('hello')\n"
SHARED = "        ('share/' + package_name, ['package.xml']),\n"


def below(files: dict[str, str | None], above: dict[str, str]) -> Example:
    """A package of a workspace whose root holds some files."""
    return Example(on="", bad={**{f"src/a/{p}": t for p, t in python(files).bad_files().items()}, **above}, good={})


def configured(text: str, other: dict[str, str], depends: str = "") -> Example:
    """A package with parameters, beside another one."""
    files = {
        "a/package.xml": manifest(build_type="ament_cmake"),
        "a/CMakeLists.txt": INSTALL,
        "a/config/robot.yaml": text,
        "b/package.xml": manifest("", "ament_cmake", "bringup").replace("  <export>", f"{depends}  <export>"),
        "b/CMakeLists.txt": INSTALL.replace("config", "launch").replace("my_pkg", "bringup"),
        **{f"b/{path}": each for path, each in other.items()},
    }
    return Example(on="", bad=files, good={})


def twin(path: str, text: str = WRONG) -> Example:
    """A package with two files of one name, and a launch file that names one."""
    cmake, launch = INSTALL.replace("config", "config param launch"), f"PATH = join({path})\n"
    files = {"config/robot.yaml": text, "param/robot.yaml": prm001.GOOD, "launch/a.launch.py": launch}
    return Example(bad={"CMakeLists.txt": cmake, **files}, good={}, on="ament_cmake")


NEEDS = "  <exec_depend>my_pkg</exec_depend>\n"
EMPTY = "<launch>{}</launch>\n"
NAMED = '<node pkg="a" exec="b"><param from="$(find-pkg-share my_pkg)/config/{}.yaml"/></node>'
FILES = (
    ({}, ""),
    ({"launch/a.launch.xml": EMPTY.format("")}, ""),
    ({"launch/a.launch.xml": EMPTY.format(NAMED.format("robot"))}, ""),
    ({"launch/a.launch.xml": EMPTY.format(NAMED.format("other"))}, NEEDS),
    ({"launch/a.launch.xml": EMPTY.format(NAMED.format("$(var b)"))}, NEEDS),
    ({"launch/a.launch.xml": EMPTY.format(NAMED.format("$(var b)"))}, ""),
    ({"launch/a.launch.xml": EMPTY.format(""), "test/a.py": "A = 'config/robot.yaml'\n"}, ""),
)
GIVES = '<launch><node pkg="a" exec="b"{}><param from="$(find-pkg-share my_pkg)/{}"/></node></launch>\n'
GIVEN = {"launch/a.launch.xml": GIVES.format("", "config/robot.yaml")}
ARGUED = (
    '<launch><arg name="p" default="{}"/><node pkg="a" exec="b"><param from="$(find-pkg-share my_pkg)/$(var p)"/>'
    "</node></launch>\n"
)
LOADED = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="a" plugin="a::B"><param from="$(find-pkg-share my_pkg)/config/robot.yaml"/></composable_node>
  </node_container>
</launch>
"""
MOVES = """\
install(FILES config/robot.yaml DESTINATION share/${{PROJECT_NAME}}/{})
install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})
ament_package"""


def moved(to: str) -> Example:
    """A package that installs its parameters in some folder, and gives a node those of `config`."""
    files = {"CMakeLists.txt": CMAKE.replace("ament_package", MOVES.format(to)), "config/robot.yaml": WRONG}
    return Example(on="config", bad={**files, "launch/a.launch.xml": GIVES.format("", "config/robot.yaml")}, good={})


HANDED = (
    *(configured(WRONG, {"launch/a.launch.xml": text}, NEEDS) for text in (
        GIVES.format("", "config/robot.yaml"),
        GIVES.format(' if="$(var c)"', "config//robot.yaml"),
        GIVES.format("", "/config/robot.yaml"),
        GIVES.format("", "config/robot.yml"),
        GIVES.format("", "param/robot.yaml"),
        GIVES.format("", "config/robot.yaml").replace("my_pkg", "other"),
        GIVES.format("", "config/robot.yaml").replace("find-pkg-share", "find-pkg-prefix"),
        GIVES.format("", "$(var c)/robot.yaml"),
        GIVES.format("", "config/robot.yaml").replace("from=", "name='a' value="),
        ARGUED.format("config/robot.yaml"),
        ARGUED.format("$(var p)"),
        LOADED,
        EMPTY.format('<include file="b"><arg name="p" value="$(find-pkg-share my_pkg)/config/robot.yaml"/></include>'),
    )),
    *(moved(to) for to in ("config", "params")),
    python({"config/robot.yaml": WRONG, "my_pkg/a.py": "A = yaml.safe_load(open('config/robot.yaml'))\n"}),
)  # fmt: skip
DEMO = "from {} import generate_demo_launch\n"


def controllers(name: str, module: str) -> Example:
    """A package with the launch file that MoveIt makes, and parameters."""
    files = {f"config/{name}.yaml": WRONG, "launch/demo.launch.py": DEMO.format(module)}
    return Example(on="config", bad={"CMakeLists.txt": INSTALL.replace("config", "config launch"), **files}, good={})


FOR_MOVEIT = (
    controllers("ros2_controllers", "moveit_configs_utils.launches"),
    controllers("controllers", "moveit_configs_utils.launches"),
    controllers("ros2_controllers", "somewhere"),
)
LEFT_OUT = {**set302.FILES, "setup.py": setup_py().replace(set302.FOUND, "[package_name]")}
START = "ros2 launch launch/a.launch.py\n"
STARTS = {
    "package.xml": manifest("  <exec_depend>launch_ros</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/talker.py": MAIN,
}
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def {}():
    return LaunchDescription([Node(package='my_pkg', executable='taker')])
"""
TARGET = "find_package(OpenGL REQUIRED)\nadd_library(a a.cpp)\nament_target_dependencies(a OpenGL "
NAMED_OTHERWISE = {
    "setup.py": OTHER_NAME.replace("zip_safe", f"{scripts('a = my_pkg.talker:main')}\n    zip_safe"),
    "my_pkg/talker.py": MAIN,
}
ROBOT = "<robot name='a'>{}</robot>\n"
MESH = "\n  <mesh filename='package://my_pkg/meshes/{}.stl'/>"
CATKIN = "project(my_pkg)\n{}\ninstall(PROGRAMS a DESTINATION b)\n"
JOINED = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([LogInfo(msg={} + 'b')])
"""
OPENS = """\
from ament_index_python.packages import get_package_share_directory

PATH = join(get_package_share_directory('my_pkg'), 'config', {})
"""
INCLUDING = {
    "package.xml": manifest("  <depend>other</depend>\n", "ament_cmake").replace("<name>other", "<name>my_pkg"),
    "CMakeLists.txt": CMAKE.replace("ament_package", "add_library(a a.cpp)\nament_package"),
    "a.cpp": "#include <other/a.hpp>\n",
}
FINDS = "find_package(Boost REQUIRED"
BRINGUP = manifest("", "cmake", "bringup").replace("  <export>", f"{NEEDS}  <export>")
LEFT = {"my_pkg/speech/words.py": "A = 1\n"}
OPENING = {"b/package.xml": BRINGUP, "b/launch/b.launch.xml": EMPTY.format("")}
CASES = {
    "SET105": (
        below(
            {"setup.py": set105.LISTED.replace("«", "").replace("»", ""), **set105.FILES},
            {"README.md": "colcon build --symlink-install\n"},
        ),
        below(
            {
                "setup.py": setup_py(scripts("a = my_pkg.nodes.talker:main", "b = my_pkg.more.a:main")).replace(
                    "find_packages(exclude=['test'])", "[package_name]"
                ),
                **set105.FILES,
                "my_pkg/more/__init__.py": "",
                "my_pkg/more/a.py": "def main():\n    print('hello')\n",
            },
            {},
        ),
    ),
    "SET302": tuple(
        below(LEFT_OUT, {"README.md": text}) for text in ("colcon build --symlink-install\n", "colcon build\n")
    ),
    "SET401": (
        python(NAMED_OTHERWISE),
        python({"setup.py": OTHER_NAME.replace(SHARED, f"{SHARED}{SHARED.replace('package.xml', 'config/a.txt')}"),
                "config/a.txt": ""}),
        python({"setup.py": OTHER_NAME.replace("data_files=[", "data_files=found() + [")}),
        *(
            python({**NAMED_OTHERWISE, "launch/a.launch.xml": f'<launch><node pkg="{name}" exec="a"/></launch>\n'})
            for name in ("your_pkg", "my_pkg")
        ),
    ),
    "SET301": (
        python({**STARTS, **LEFT}),
        python({**STARTS, **LEFT, "my_pkg/talker.py": "from my_pkg.speech.words import A\n" + MAIN}),
        below({**STARTS, **LEFT}, {"b/package.xml": BRINGUP}),
        below({**STARTS, "my_pkg/speech/words.py": "#!/usr/bin/env python3\nprint(1)\n"}, {"b/package.xml": BRINGUP}),
        python({**LEFT, "my_pkg/talker.py": MAIN}),
    ),
    "LCH002": tuple(
        python({**STARTS, "start.sh": START, "launch/a.launch.py": LAUNCH.format(name)})
        for name in ("generate_launch_description", "make")
    ),
    "DEP104": tuple(
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package", f"{FINDS}{parts})\nament_package")}, good={},
                on="ament_cmake")
        for parts in (" COMPONENTS thread", " COMPONENTS thread program_options", " COMPONENTS none", "")
    ),
    "LCH014": (
        python({**STARTS, "start.sh": START, "launch/a.launch.py": JOINED.format("str(LaunchConfiguration('a'))")}),
        python({**STARTS, "start.sh": START, "launch/a.launch.py": JOINED.format("LaunchConfiguration('a')")}),
    ),
    "CMK201": tuple(
        Example(bad={**{f"a/{path}": each for path, each in INCLUDING.items()},
                "b/package.xml": manifest("", "ament_cmake", "other"),
                "b/CMakeLists.txt": CMAKE.replace("my_pkg", "other"), f"b/include/{folder}/a.hpp": ""}, good={}, on="")
        for folder in ("other/other", "other/others")
    ),
    "SET206": tuple(
        python({"setup.py": setup_py(), "config/a.yaml": "a: 1\n", "launch/a.launch.py": OPENS.format(name)})
        for name in ("'a.yaml'", "'b.yaml'", "name")
    ) + tuple(
        below({"setup.py": setup_py(), **{f"config/{name}": "" for name in names}}, OPENING)
        for names in (("a.yaml",), ("a.yaml", "b.rviz"), ("a.yaml", "b.txt"), ("b.rviz",))
    ),
    "CMK117": tuple(
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package", f"{TARGET}{name})\nament_package"), "a.cpp": ""},
                good={}, on="ament_cmake")
        for name in ("OpenCV", "OpenGl")
    ),
    "WSP001": tuple(
        Example(bad={f"{folder}/package.xml": manifest("", "cmake", "arm") for folder in folders}, good={}, on="")
        for folders in (
            ("one_ws/arm", "two_ws/arm"), ("one_ws/arm", "two_ws/src/arm"), ("one_ws/arm", "pio/extra_packages/arm"),
            ("one_ws/arm", "one_ws/arms"), ("one_ws/arm", "arm"), ("one/arm", "arm_ws"),
        )
    ),
    "WSP005": tuple(
        Example(bad={"package.xml": manifest("", "cmake"), **{f"{each}/package.xml": manifest("", "cmake", "arm")
                for each in folders}}, good={}, on="")
        for folders in (("legacy/arm",), ("legacy/arm", "now/arm"))
    ),
    "URD002": (
        *(
        Example(bad={"CMakeLists.txt": INSTALL.replace("config", "urdf meshes"), "meshes/x.stl": "",
                     "urdf/a.urdf": ROBOT.format("".join(MESH.format(name) for name in names)),
                     "launch/a.launch.py": "PATH = 'urdf/a.urdf'\n"}, good={}, on="ament_cmake")
        for names in ("abc", "ab", "abx", "abcx")
        ),
        Example(bad={"CMakeLists.txt": INSTALL.replace("config", "urdf meshes"), "meshes/x y.stl": "",
                     "urdf/a.urdf": ROBOT.format("<gazebo><uri> package://my_pkg/meshes/x y.stl </uri></gazebo>"),
                     "launch/a.launch.py": "PATH = 'urdf/a.urdf'\n"}, good={}, on="ament_cmake"),
    ),
    "XML307": (
        python({"CMakeLists.txt": CATKIN.format("catkin_package()")}),
        python({"CMakeLists.txt": CATKIN.format("find_package(catkin)")}),
        python({"CMakeLists.txt": INSTALL, "config/a.yaml": ""}),
        python({"CMakeLists.txt": INSTALL.replace("config", "config docs"), "config/a.yaml": "", "docs/a.md": ""}),
    ),
    "PRM001": (
        *(configured(WRONG, *each) for each in FILES),
        *HANDED,
        *FOR_MOVEIT,
        *(
            twin(f"'{path}'")
            for path in ("config', 'robot.yaml", "param', 'robot.yaml", "config/robot.yaml", "robot.yaml")
        ),
    ),
    "PRM004": (
        *(configured(LIST, *each) for each in FILES[:2]),
        *(configured(text, GIVEN) for text in (LIST, EMPTY_LIST)),
        configured(EMPTY_LIST, {}),
        *(
            twin(f"'config/robot.yaml'), {text}", UNSET)
            for text in ("RewrittenYaml({'rate': '1'}", "Node({'rate': '1'}", "RewrittenYaml({'rates': '1'}")
        ),
    ),
}  # fmt: skip
