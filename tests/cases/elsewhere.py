"""What lies elsewhere in a package, or beside it, and makes a finding milder or needless."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_PY, Example, manifest, scripts, setup_py
from rospkg_cli.rules.cmake import cmk105_script_not_executable as cmk105
from rospkg_cli.rules.setup import set002_wrong_script_dir as set002
from rospkg_cli.rules.setup import set107_uninstalled_script as set107


def plain(text: str) -> str:
    return text.replace("«", "").replace("»", "")


def on_python(files: dict[str, str]) -> Example:
    return Example(bad=files, good={})


def on_cmake(lines: str, files: dict[str, str], body: str = "") -> Example:
    text = CMAKE.replace("ament_package", lines + "\nament_package")
    package = {"CMakeLists.txt": text, "package.xml": manifest(body, "ament_cmake"), **files}
    return Example(bad=package, good={}, on="ament_cmake")


DEEP = "my_pkg/moves/turn.py"
INSTALLED = f"install(FILES {DEEP} DESTINATION lib/${{PROJECT_NAME}})"
MODULE = f"{cmk105.SHEBANG}def a():\n    pass\n\n\nfor _ in ():\n    a()\n"
STARTED = f"{MODULE}\n\nif __name__ == '__main__':\n    a()\n"
BY_DOTS = (
    "from my_pkg.moves.turn import a\n",
    "import my_pkg.moves.turn as turn\n",
    "    from .moves import (\n  go, turn)\n",
)
OF_OTHERS = ("import my_pkg.moves.turner\nfrom my_pkg.moves import returns  # turn\nturn = 1\n", "import turn\n")


def moved(importing: str, module: str = MODULE) -> Example:
    """A package that installs a module as a program, and another module."""
    return on_cmake(INSTALLED, {DEEP: module, "my_pkg/a.py": importing})


TODO = (
    manifest()
    .replace("Drives my robot", "TODO: Package description")
    .replace("Apache-2.0", "TODO: License declaration")
    .replace("ada@example.org", "ada@todo.todo")
)
CATKIN = "  <buildtool_depend>catkin</buildtool_depend>\n"
AMENT = "  <buildtool_depend>ament_cmake</buildtool_depend>\n"


def built_by(tools: str, text: str = TODO) -> Example:
    return Example(bad={"package.xml": text.replace("\n  <export>", f"\n{tools}  <export>")}, good={}, on="")


BATTERY = {"msg/Battery.msg": "float32 level\n"}
USER = {f"user/{path}": text for path, text in {
    "package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n").replace("<name>my_pkg", "<name>user"),
    "setup.py": SETUP_PY.replace("'my_pkg'", "'user'"), "resource/user": "", "user/__init__.py": "",
    "setup.cfg": "[develop]\nscript_dir=$base/lib/user\n[install]\ninstall_scripts=$base/lib/user\n",
}.items()}  # fmt: skip
OWN = {f"my_pkg/{path}": text for path, text in {
    "package.xml": manifest(), "setup.py": SETUP_PY, "resource/my_pkg": "", "my_pkg/__init__.py": "", **BATTERY,
}.items()}  # fmt: skip

LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = get_package_share_directory('my_pkg') + '/config/a.yaml'
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[config])])
"""
ABOVE = (
    "get_filename_component(UP ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)\nget_filename_component(TOP ${UP} DIRECTORY)\n"
    "if(EXISTS ${TOP}/scripts/a.yaml)\n  install(FILES ${TOP}/scripts/a.yaml DESTINATION share/my_pkg/config)\nendif()"
)
ARGUMENTS = '<launch>\n  <arg name="imu_topic" default="a"/>\n  <log message="$(var {})"/>\n</launch>\n'
FINDS = '<launch>\n  <include file="$(find-pkg-share {})/a.launch.xml"/>\n</launch>\n'

CASES = {
    "CMK105": (
        *(moved(text) for text in (*BY_DOTS, *OF_OTHERS)),
        moved(BY_DOTS[0], STARTED),
        on_cmake(INSTALLED, {DEEP: STARTED, "cmake/turn.cmake": "set(TURN ${DIR}/../turn.py)\n"}),
        on_cmake(INSTALLED, {DEEP: STARTED, "cmake/turn.cmake": "set(TURN ${DIR}/return.py)\n"}),
        on_cmake(INSTALLED.replace(".py", ""), {"my_pkg/moves/turn": "#!/bin/sh\nexit\n", "my_pkg/a.py": BY_DOTS[0]}),
    ),
    "DEP101": (
        on_python({"package.xml": manifest("  <test_depend>launch_ros</test_depend>\n"),
                   "my_pkg/a.py": "import launch\nimport std_srvs.srv\n"}),
        on_python({"package.xml": manifest("  <test_depend>nobody_knows</test_depend>\n"),
                   "my_pkg/a.py": "import launch\nimport pytest\n"}),
        on_python({"my_pkg/a.py": "import depthai\n"}),
        on_python({"package.xml": manifest("  <exec_depend>sensor_msgs</exec_depend>\n"
                                           "  <test_depend>geometry_msgs</test_depend>\n"),
                   "my_pkg/a.py": "import std_msgs.msg\n"}),
    ),
    "DEP103": tuple(
        Example(bad={**OWN, "my_pkg/msg/Battery.msg": None, "my_pkg/launch/a.launch.xml": FINDS.format(name),
                     "start.sh": "ros2 launch my_pkg/launch/a.launch.xml\n",
                     f"{known}/package.xml": manifest(name=known)}, good={}, on="")
        for known, name in (
            ("acme_robot_test", "acme_robot_dope"), ("acme_robot_agent", "acme_robot_rest_api"),
            ("acme_robot_test", "acme_robto_test"), ("acme_robot_test", "acmerobot_test"),
            ("acme_robot_test", "bcme_robot_test"), ("acme_robot_test", "acme_robot_test_dir"),
        )
    ),
    "SET301": tuple(
        Example(bad={**OWN, "README.md": text, "my_pkg/my_pkg/speech/words.py": "A = 1\n",
                     "my_pkg/my_pkg/a.py": "from my_pkg.speech.words import A\n"}, good={}, on="")
        for text in ("colcon build --symlink-install\n", "colcon build\n")
    ),
    "IDL008": (
        on_python(BATTERY),
        on_python({**BATTERY, "my_pkg/a.py": "    from my_pkg import (msg)\n"}),
        on_python({**BATTERY, "my_pkg/a.py": "import my_pkg.msg\n"}),
        on_python({**BATTERY, "my_pkg/a.py": "import my_pkg.battery\n"}),
        on_python({**BATTERY, "my_pkg/a.py": "# import my_pkg.msg\nfrom my_pkg_more.msg import Battery\n"}),
        on_python({**BATTERY, "a.txt": "import my_pkg.msg\n"}),
        Example(bad={**OWN, **USER}, good={}, on=""),
        *(on_python({"my_pkg/msg/Battery.msg": "float32 a\n", **more})
          for more in (
              {}, {"my_pkg/a.py": "from my_pkg.msg import Battery\n"},
              {"my_pkg/a.py": "from my_pkg.msg import Battery\n", "my_pkg/msg/__init__.py": ""},
          )),
    ),
    "LCH003": (
        *(on_cmake(f"{lines}\ninstall(DIRECTORY launch DESTINATION share/my_pkg)", {"launch/a.launch.py": LAUNCH})
          for lines in (
              ABOVE, ABOVE.replace("/scripts/a.yaml DEST", "/scripts/b.yaml DEST"),
              "install(FILES ../a.yaml DESTINATION share/my_pkg/config)",
              "install(DIRECTORY ../config DESTINATION share/my_pkg)",
          )),
    ),
    "LCH008": tuple(
        on_python({"launch/a.launch.xml": ARGUMENTS.format(name)}) for name in ("cmd_topic", "iuu_topic", "imutopic")
    ),
    "SET002": tuple(
        on_python({**set002.PACKAGE, "setup.cfg": plain(text)})
        for text in (
            "[develop]\nscript_dir=$base/lib/your_pkg\n[install]\ninstall_scripts=$base/lib/my_pkg\n",
            "[install]\ninstall_scripts=$base/lib/my_pkg\n",
        )
    ),
    "SET107": (
        on_python({
            "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
            "setup.py": setup_py(scripts("listener = my_pkg.listener:main")),
            "my_pkg/listener.py": plain(set107.NODE), "scripts/talker.py": plain(set107.NODE),
        }),
    ),
    "XML104": (
        built_by(CATKIN), built_by("  <depend>catkin</depend>\n"), built_by(CATKIN + AMENT), built_by(AMENT),
        built_by(CATKIN, TODO.replace("TODO: Package description", "")),
    ),
}  # fmt: skip
