"""Places that seldom or never run: in a function that nothing calls, in a branch, behind `spin`, by a default."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

NEEDS = "".join(
    f"  <exec_depend>{name}</exec_depend>\n" for name in ("rclpy", "std_msgs", "ament_index_python", "std_srvs")
)
FILES = {
    "package.xml": manifest(NEEDS),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/speech.py": "GREETING = 'hello'\n",
    "names/people.txt": "Ada\n",
}
HEAD = """\
import os
import sys

import rclpy
from ament_index_python.packages import get_package_share_directory
from std_msgs.msg import String

"""
PLACES = (
    "def main():\n    {}\n",
    "def main():\n    if len(sys.argv) > 1:\n        {}\n",
    "def main():\n    return\n\n\ndef idle():\n    {}\n",
    "def main():\n    rclpy.spin(rclpy.create_node('talker'))\n    {}\n",
    "def main():\n    return\n\n\nif __name__ == '__main__':\n    {}\n",
    "TESTING = False\n\n\ndef main():\n    if TESTING:\n        {}\n",
    "def main():\n    sys.exit(0)\n    {}\n",
)
"""Where a line is met by everybody, in some runs, by nobody, behind spin, by path, with a switch, behind the end."""

FILE = "os.path.join(get_package_share_directory('my_pkg'), 'names', 'people.txt')"
PATH = f"open(«{FILE}»)"
OPENED = (
    "def main():\n    print(open(sys.argv[1] if sys.argv[1:] else {}))\n",
    "def main():\n    print(open(os.getenv('PEOPLE', {})))\n",
    "def main(node=rclpy.create_node('a')):\n    node.declare_parameter('people', {})\n",
    "def main():\n    people({0})\n\n\ndef people(path={0}):\n    print(open(path))\n",
    "def main():\n    try:\n        print(open({}))\n    except OSError:\n        print('nobody')\n",
    "def main():\n    try:\n        print(open({}))\n    except ValueError:\n        print('nobody')\n",
)


def met(line: str, place: str, **files: str) -> Example:
    return Example(bad={**FILES, "my_pkg/talker.py": HEAD + "\n" + place.format(line), **files}, good={})


def everywhere(line: str, count: int = len(PLACES)) -> tuple[Example, ...]:
    return tuple(met(line, place) for place in PLACES[:count])


def pip(page: str, text: str) -> Example:
    return met("pass", "import «serial»\n\n\n" + PLACES[0], **{page: text})


LEFT = {"my_pkg/talker.py": PLACES[0].format("pass"), "my_pkg/left.py": "from my_pkg.«speach» import GREETING\n"}
NAMED = "# '{0} = my_pkg.{0}:main',\n"

CASES = {
    "DEP101": (
        *(met("import «cv2»", PLACES[number]) for number in (0, 2, 3, 4)),
        pip("README.md", "Type `pip3 install pyserial`.\n"),
        pip("install.sh", "pip install --user pyserial\n"),
        Example(
            bad={
                **FILES,
                "setup.py": NAMED.format("left") + FILES["setup.py"],
                "my_pkg/talker.py": PLACES[0].format("pass"),
                "my_pkg/left.py": "import «cv2»\n",
            },
            good={},
        ),
        Example(
            bad={
                **FILES,
                "my_pkg/talker.py": "import «cv2»\n\n\n" + PLACES[0].format("print(cv2)"),
                "my_pkg/left.py": "import cv2\n",
            },
            good={},
        ),
    ),
    "DEP109": (*everywhere("import my_pkg.«speach»", 5), Example(bad={**FILES, **LEFT}, good={})),
    "DEP110": everywhere("from «speech» import GREETING", 4),
    "DEP112": everywhere("get_package_share_directory('«my_pgk»')", 6),
    "DEP113": (*everywhere(PATH, 6), *(met(f"«{FILE}»", place) for place in OPENED)),
    "DEP117": (
        met("Words.said", "class Words:\n    @staticmethod\n    def said():\n        «modes»()\n\n\n" + PLACES[0]),
        met("pass", "class Words:\n    @staticmethod\n    def said():\n        «modes»()\n\n\n" + PLACES[0]),
        met(
            "pass",
            "from my_pkg.words import Words\n\n\n" + PLACES[0],
            **{"my_pkg/words.py": "class Words:\n    def __init__(self):\n        «modes»()\n"},
        ),
    ),
    "DEP120": (
        met(
            "pass",
            "def main():\n    try:\n        rclpy.init()\n    except rclpy.«ROSInterruptException»:\n        {}\n",
        ),
    ),
    "IDL010": everywhere("String().«datta» = 'a'", 5),
    "IDL011": everywhere("from std_msgs.msg import «Sting»", 5),
}
