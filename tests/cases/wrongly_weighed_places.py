"""Places that seldom or never run: in a function that nothing calls, in a branch, behind `spin`, by a default."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

from .shown_cmake import package

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


def imported(how: str, text: str) -> Example:
    """A module that another one imports in some way."""
    return met("import my_pkg.draw", how, **{"my_pkg/draw.py": text})


def imported_in_all_ways(text: str) -> tuple[Example, ...]:
    return tuple(imported(how, text) for how in (PLACES[0], PLACES[2], TRIED))


TRIED = "try:\n    {}\nexcept ImportError:\n    pass\n\n\ndef main():\n    return\n"
BUILT = {"setup.py": FILES["setup.py"].replace("    install_requires", "    ext_modules=FAST,\n    install_requires")}
STARTED = "if __package__:\n    from my_pkg.speech import GREETING\nelse:\n    {}\n\n\n" + PLACES[0].format("pass")
IFS = {
    f"{folder}/{name}": text
    for folder, field in (("b", "data"), ("c", "text"))
    for name, text in {
        "package.xml": manifest("", "ament_cmake").replace("my_pkg", "my_ifs"),
        "CMakeLists.txt": CMAKE.replace("my_pkg", "my_ifs").replace(
            "ament_package", "rosidl_generate_interfaces(my_ifs msg/Word.msg)\nament_package"
        ),
        "msg/Word.msg": f"string {field}\n",
    }.items()
}
MINE = {
    f"a/{path}": text
    for path, text in met("my_ifs.msg.Word().text = 'a'", "import my_ifs.msg\n\n\n" + PLACES[0]).bad_files().items()
}
ASKED = "def main():\n    word = String()\n    if hasattr(word.data, 'text'):\n        {}\n"
SKIPPED = "def test_a():\n    pass\n\n\ndef draw():\n    import «cv2»\n"

SAMPLE = "def way():\n    return 1\n\n\ndef main():\n    «modes»()\n\n\nif __name__ == '__main__':\n    main()\n"
WAY = "from my_pkg.way import way\n\n\n" + PLACES[0].format("way()") + "\n\nif __name__ == '__main__':\n    main()\n"

LINTED = "from ament_copyright.main import main\n\n\ndef test_copyright():\n    assert main(argv=['.']) == 0\n"


def sample(**files: str) -> Example:
    """A module that shows itself where it is started by its path, as copies from collections of algorithms do."""
    return met("pass", WAY, **{"my_pkg/way.py": SAMPLE}, **files)


LEFT = {"my_pkg/talker.py": PLACES[0].format("pass"), "my_pkg/left.py": "from my_pkg.«speach» import GREETING\n"}
NAMED = "# '{0} = my_pkg.{0}:main',\n"

COMPILED = (
    "add_executable(talker src/talker.cpp)",
    "add_executable(talker EXCLUDE_FROM_ALL src/talker.cpp)",
    "add_executable(teller src/teller.cpp)\ninstall(FILES src/talker.cpp DESTINATION src)",
)
IN_CPP = {"src/talker.cpp": "#include «<std_msgs/msg/strng.hpp>»\n", "src/teller.cpp": "int main() {}\n"}

CASES = {
    "DEP101": (
        *(met("import «cv2»", PLACES[number]) for number in (0, 2, 3, 4)),
        *imported_in_all_ways("import «cv2»\n"),
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
    "DEP102": (met("pass", PLACES[0], **{"test/test_a.py": SKIPPED}),),
    "DEP109": (
        *everywhere("import my_pkg.«speach»", 5),
        Example(bad={**FILES, **LEFT}, good={}),
        *imported_in_all_ways("import my_pkg.«speach»\n"),
        met("import my_pkg.fast", PLACES[0], **BUILT),
        met("from my_pkg.words import word_pb2", PLACES[0]),
    ),
    "DEP110": (
        *everywhere("from «speech» import GREETING", 4),
        *imported_in_all_ways("from «speech» import GREETING\n"),
        met("from speech import GREETING", STARTED),
        met("from speech import GREETING", "import site\n\nsite.addsitedir('/opt')\n\n\n" + PLACES[0]),
    ),
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
        *imported_in_all_ways("«modes»()\n"),
        sample(),
        sample(**{"test/test_copyright.py": LINTED}),
        sample(**{"README.md": "Type `python3 my_pkg/way.py` to see it.\n"}),
    ),
    "DEP120": (
        met(
            "pass",
            "def main():\n    try:\n        rclpy.init()\n    except rclpy.«ROSInterruptException»:\n        {}\n",
        ),
    ),
    "IDL010": (
        *everywhere("String().«datta» = 'a'", 5),
        *imported_in_all_ways("from std_msgs.msg import String\n\nString().«datta» = 'a'\n"),
        met("word.data.text = 'a'", ASKED),
        Example(on="", bad={**MINE, **IFS}, good={}),
    ),
    "IDL012": tuple(package(lines, files=IN_CPP, needs=("std_msgs",)) for lines in COMPILED),
    "IDL011": (
        *everywhere("from std_msgs.msg import «Sting»", 5),
        *imported_in_all_ways("from std_msgs.msg import «Sting»\n"),
    ),
}
