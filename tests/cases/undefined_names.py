"""Names that nothing binds: how bad each place is, what it is told, and where there may be one after all."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py

from .setups import python
from .shown_imports import MIXED, MIXED_CMAKE

STARTED = setup_py(scripts("talker = my_pkg.talker:main"))
WORDS = {"my_pkg/words.py": "GREETING = 'hello'\n"}
PROGRAM = MIXED_CMAKE.replace(
    "ament_python_install_package(my_pkg)", "install(PROGRAMS scripts/talk.py DESTINATION lib/my_pkg)"
)

STRAIGHT = (
    "def main():\n    sys.exit(1)\n",
    "import os\n\n\ndef main():\n    sys.exit(os.system('ls'))\n",
    "def main():\n    if input():\n        sys.exit(1)\n",
    "def main():\n    if input():\n        return\n    print(modes)\n",
    "def main():\n    try:\n        print(modes)\n    except KeyboardInterrupt:\n        print(mode)\n",
    "def main():\n    try:\n        print(modes)\n    except Exception:\n        pass\n",
    "def main():\n    with open('a') as modes:\n        say(modes)\n\n\n"
    "def say(mode):\n    print(mode, mood)\n    print(mood)\n",
    "def main():\n    Talker().say()\n\n\nclass Talker:\n    def __init__(self):\n        self.start()\n\n"
    "    def start(self):\n        print(modes)\n\n    def say(self):\n        print(moods)\n",
    "def main():\n    print(lambda: modes, [mode for each in modes], input() and mood)\n",
    "def main():\n    for each in modes:\n        print(mode)\n    assert mood\n",
    "def main(): ...\n\n\ndef idle():\n    print(modes)\n",
    "class Talker(Node):\n    def idle(self):\n        print(modes)\n\n\ndef main():\n    Talker()\n",
    "class Talker(Node):\n    def idle(self):\n        print(modes)\n        print('idle')\n\n\ndef main():\n"
    "    Talker()\n",
    "class Talker(LifecycleNode):\n    def idle(self):\n        print(modes)\n\n    def on_configure(self, state):\n"
    "        print(mood)\n\n\ndef main():\n    Talker()\n",
    "def main():\n    Talker()\n    print(modes)\n\n\nclass Talker:\n    def __init__(self):\n        while True:\n"
    "            print(mode)\n",
    "def main():\n    while True:\n        print('a')\n    print(modes)\n",
    "def main():\n    for each in ('a', 'b'):\n        getattr(here, f'say_{each}')()\n\n\n"
    "def say_a():\n    print(modes)\n",
    "def main(): ...\n\n\ndef draw():\n    corners()\n\n\ndef corners():\n    print(modes)\n",
    "class Talker:\n    def say(self):\n        print(modes)\n\n\ndef main(): ...\n",
    "from threading import Thread\n\n\nclass Talker(Thread):\n    def run(self):\n        print(modes)\n\n\n"
    "def main():\n    Talker().start()\n",
    "class Talker:\n    def say(self):\n        self._say()\n\n    def _say(self):\n        print(modes)\n\n"
    "    def _tell(self, mode: Mood):\n        print(moods)\n\n\ndef main():\n    getattr(Talker(), 'say')()\n",
    "class Talker:\n    CENTER = 5\n\n    def __init__(self):\n        self.mode = CENTER\n        say(mode)\n\n"
    "    def say(self): ...\n\n    @staticmethod\n    def still():\n        print(CENTER)\n\n\n"
    "def main():\n    Talker()\n",
    "def main(text: Text, *others: 'Others') -> Speech:\n    mode: Mode = text\n    print(mode)\n",
    "from __future__ import annotations\n\n\ndef main(text: Text): ...\n",
    "class Talker:\n    mode: Mode = 1\n\n\ndef main(): ...\n",
)
QUIET = (
    "from numpy import *\n\n\ndef main():\n    print(modes)\n",
    "globals()['modes'] = 1\n\n\ndef main():\n    print(modes)\n",
    "def main():\n    try:\n        print(modes)\n    except NameError:\n        pass\n",
    "def main():\n    try:\n        print(unicode('a'))\n    except:\n        pass\n",
    "import sys\n\n\ndef main():\n    if sys.version_info[0] < 3:\n        print(raw_input())\n",
    "def main():\n    print(_('hello'), ExceptionGroup, exit)\n",
    "Import('env')\n\n\ndef main():\n    print(env)\n",
    "if input():\n    modes = 1\n\n\ndef main():\n    print(modes)\n",
    "def generate_launch_description():\n    return modes\n\n\ndef main(): ...\n",
)


def talker(text: str, **files: str) -> Example:
    paths = {f"{path.replace('__', '/')}.py": each for path, each in files.items()}
    return python({"setup.py": STARTED, **WORDS, "my_pkg/talker.py": text, **paths})


CASES = {
    "DEP117": (
        *map(talker, STRAIGHT),
        *map(talker, QUIET),
        talker("def main():\n    print(raw_input())\n"),
        talker(
            "import os.path\nimport sys as system\n\n\ndef main():\n    os.path.exist('a')\n    if system.args:\n"
            "        os.join('a', os.linesep, os.startfile, os.environment)\n"
        ),
        talker("from xml.etree.ElementTree import ET\nfrom collections import Mapping\n\n\ndef main(): ...\n"),
        talker("import datetime\nimport string\n\n\ndef main():\n    string.letters[datetime.now():]\n"),
        talker("import sys\nimport logging\n\n\ndef main():\n    print(sys.frozen, logging.TRACE)\n"),
        talker("import types\n\n\ndef main(): ...\n", my_pkg__queue="A = 1\n", my_pkg__b="from queue import A\n"),
        talker("import time\nfrom time import slep\n\n\ndef main(): ...\n"),
        talker(
            "import os, time, sys\n\n\ndef main():\n    time = 1\n    time.clock()\n    try:\n        sys.maxint\n"
            "    except AttributeError:\n        pass\n    if sys.version_info[0] < 3:\n        os.getcwdu()\n"
        ),
        talker("import sys\n\n\ndef main():\n    if hasattr(sys, 'args'):\n        print(sys.args)\n"),
        talker(
            "def main(): ...\n",
            launch__a_launch="import os\n\n\ndef generate_launch_description():\n    return os.path.joint('a')\n",
        ),
        talker("from .words import *\n\n\ndef main():\n    print(GREETING, GRETING)\n"),
        talker("from my_pkg.words import hi\n\n\ndef main():\n    print(GREETING)\n"),
        talker("def main(): ...\n", my_pkg__other="print(modes)\n"),
        talker(
            "def main(): ...\n",
            my_pkg__other="def idle():\n    print(modes)\n",
            my_pkg__third="from .other import idle\n",
        ),
        talker("def main(): ...\n", test__test_words="def test_words():\n    assert modes\n"),
        talker("def main(): ...\n", tools__plot="print(modes)\n"),
        talker("def main(): ...\n", launch__helper="print(modes)\n"),
        talker("def main(): ...\n", launch__start="if __name__ == '__main__':\n    print(modes)\n"),
        python({**WORDS, "my_pkg/talker.py": "print(modes)\n"}),
        Example(
            on="ament_cmake",
            bad={
                **MIXED,
                "CMakeLists.txt": PROGRAM,
                "scripts/talk.py": "def main():\n    print(modes)\n\n\nif __name__ == '__main__':\n    main()\n",
                "scripts/plot.py": "print(modes)\n",
                "scripts/old/plot.py": "print(modes)\n",
            },
            good={},
        ),
    ),
}
