"""What nothing leads to: modules, methods and branches that are told of in a milder way."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

from .setups import python
from .shown_cmake import package
from .shown_fields import SERVE, code
from .shown_fields import node as node_of
from .undefined_names import talker

HEAD = "import rclpy\nfrom rclpy.node import Node\n\n\n"
BROKEN = "def draw():\n    print(modes)\n"
START = "\n\ndef main():\n    Talker().say()\n"


def node(*methods: str, start: str = "self.on = False", more: str = "", end: str = START) -> str:
    """A node with methods; each may begin with its name and a colon, behind which its only line stands."""
    bodies = (each.partition(": ") for each in methods)
    text = "".join(f"\n    def {name}(self):\n        {line}\n" for name, _, line in bodies)
    first = f"    def __init__(self):\n        super().__init__('talker')\n        {start}\n"
    return f"{HEAD}class Talker(Node):\n{more}{first}{text}{end}"


OTHER = "\n\nclass Other(Node):\n    def go(self):\n        self.stop()\n\n    def stop(self): ...\n"
HEIR = OTHER.replace("(Node)", "(Talker)").replace("    def stop(self): ...\n", "")
MAIN = "\n\ndef main():\n    Talker().say(), Other('a').go()\n"
TEST = ("say: if self.on: self.probe()", "probe: print(modes)")

LIBRARY = "class Words:\n    def say({0}):\n        print(modes)\n\n\n"

MEANT = node_of("", "def serve(self, request: Status, response: Status) -> Status:\n    response.{} = request.{}\n")
RESPONSE = MEANT.replace("def __init__(self):\n", f"def __init__(self):\n        {SERVE}")
IN_FUNCTION = "def main():\n    {}\n\n\ndef idle():\n    from std_msgs.msg import Sting\n    print(Sting)\n"
HOME = "def main():\n    {}\n\n\ndef idle():\n    open('/home/ada/ws/src/my_pkg/my_pkg/a.txt')\n"

LAUNCH_TEST = """\
import os

import launch_ros
from ament_index_python import get_package_share_directory


def generate_test_description():
    return launch_ros, os.path.join(get_package_share_directory('my_pkg'), 'config', 'robt.yaml')
"""
TESTED = "install(DIRECTORY config DESTINATION share/${{PROJECT_NAME}})\nif(BUILD_TESTING)\n  {}\nendif()\n"
REGISTERED = (
    "# add_launch_test(test/test_talk.py)",
    "add_launch_test(test/test_talk.py)",
    "add_launch_test(${WHICH})",
    "ament_add_pytest_test(talk test)",
    "my_tests(a/test_talk.py)",
)


def registered(lines: str, path: str = "test/test_talk.py") -> Example:
    files = {path: LAUNCH_TEST, "config/robot.yaml": "a: 1\n"}
    return package(TESTED.format(lines), files=files, needs=("ament_index_python",))


MAIN_CPP = "int main() { return 0; }\n"
TYPED = f"#include <geometry_msgs/msg/pose_stamped.hpp>\nstd_msgs::msg::Header header;\n{MAIN_CPP}"
FOR_ROS1 = f"#include <nav_msgs/msg/path.hpp>\n{MAIN_CPP}"


def compiled(lines: str, text: str, needs: str = "") -> Example:
    files = {"src/a.cpp": text, "package.xml": manifest(needs, "ament_cmake")}
    return package("add_executable(b src/b.cpp)", lines, files={"src/b.cpp": MAIN_CPP, **files})


ONLY_ROS1 = '  <depend condition="$ROS_VERSION == 1">nav_msgs</depend>\n'

CASES = {
    "DEP105": (
        compiled("add_executable(a src/a.cpp)", TYPED),
        compiled("add_executable(a src/a.cpp)", TYPED.replace("#include", "//")),
        compiled("if(WITH_A)\n  add_executable(a src/a.cpp)\nendif()", FOR_ROS1, ONLY_ROS1),
        compiled("if(WITH_A)\n  add_executable(a src/a.cpp)\nendif()", FOR_ROS1),
        compiled("add_executable(a src/a.cpp)", FOR_ROS1, ONLY_ROS1),
    ),
    "DEP102": (
        *map(registered, REGISTERED),
        registered("", "launch/talk.launch.py"),
        python({"test/talk.launch.py": LAUNCH_TEST}),
        python({"test/test_talk.launch.py": LAUNCH_TEST}),
    ),
    "DEP113": tuple(map(registered, REGISTERED)),
    "IDL010": (
        code(RESPONSE.format("success", "mode")),
        code(RESPONSE.format("succes", "battery")),
    ),
    "IDL011": tuple(talker(IN_FUNCTION.format(each)) for each in ("pass", "idle()")),
    "DEP118": tuple(talker(HOME.format(each)) for each in ("pass", "idle()")),
    "DEP117": (
        talker(
            "from my_pkg.dot_qt import GREETING\n\n\ndef main(): ...\n",
            my_pkg__dot=BROKEN,
            my_pkg__dot_qt="GREETING = 1\n",
        ),
        talker(node(*TEST)),
        talker(node(*TEST, start="self.on = True")),
        talker(node(*TEST, "start: self.on = True")),
        talker(node(*TEST, start="pass", more="    on = False\n\n")),
        talker(node(*TEST, more="    on = False\n\n")),
        talker(node(*TEST, "start: setattr(self, 'on', True)")),
        talker(node("say: print(modes) if self.on else 1")),
        talker(node("say: if self.on: print(modes)")),
        talker("ON = False\n" + node("say: if ON: self.probe()", "probe: print(modes)")),
        talker(
            "ON = False\n" + node("say: if ON: self.probe()", "probe: print(modes)"), my_pkg__b="import a\na.ON = 1\n"
        ),
        talker(node("say: pass", "stop: print(modes)", end=OTHER + MAIN)),
        talker(node("say: pass", "stop: print(modes)", end=HEIR + MAIN)),
        talker(node("say: pass", "stop: print(modes)", end=START.replace(".say", ".stop"))),
        talker(node("say: pass", "stop: print(modes)", end=OTHER + MAIN).replace("r(Node)", "r(object)")),
        python({"my_pkg/words.py": LIBRARY.format("")}),
        python({"my_pkg/words.py": LIBRARY.format("self")}),
        python({"my_pkg/words.py": LIBRARY.format("") + "Words.say()\n"}),
    ),
}
