"""Sentences about imports of the workspace's own modules that no example shows."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY, Example, manifest, scripts, setup_py

from .setups import python

SPEECH = {"my_pkg/speech.py": "GREETING = 'hello'\n\n\ndef say():\n    global said\n    said = 1\n"}
INNER = {"my_pkg/inner/__init__.py": "from .deep import A\n", "my_pkg/inner/deep.py": "A = 1\n"}
STARTED = {**SPEECH, "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "b = my_pkg.other:main"))}
MAIN = "\n\ndef main():\n    print(GREETING)\n"
MIXED_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
ament_python_install_package(my_pkg)
ament_package()
"""
MIXED = {
    "package.xml": manifest("  <buildtool_depend>ament_cmake_python</buildtool_depend>\n", "ament_cmake"),
    "CMakeLists.txt": MIXED_CMAKE,
    "my_pkg/__init__.py": "",
}


def importing(text: str, **files: str | None) -> Example:
    paths = {name.replace("__", "/").replace("_DOT_", "."): each for name, each in files.items()}
    return python({**SPEECH, "my_pkg/talker.py": text, **paths})


WRONG = "from my_pkg.speach import GREETING\n"
REACHING: tuple[dict[str, str], ...] = (
    {},
    {"my_pkg/other.py": "from .inner import deep\n\n\ndef main(): ...\n"},
    {"my_pkg/other.py": "import my_pkg.inner.other\n\n\ndef main(): ...\n", "my_pkg/inner/other.py": ""},
    {"my_pkg/unused.py": "import my_pkg.inner.deep\n"},
    {"test/test_a.py": "from my_pkg.inner.deep import A\n"},
    {"launch/a.launch.py": "from my_pkg.inner.deep import A\n"},
    {"urdf/a.urdf": "<robot><plugin type='my_pkg.inner.deep.Driver'/></robot>\n"},
    {"urdf/a.urdf": "<robot><plugin type='my_pkg.inner.deeper.Driver'/></robot>\n"},
    {"my_pkg/__init__.py": "from . import inner\n"},
)


def started(files: dict[str, str]) -> Example:
    """A package that starts two modules, and has another one that ends at an import."""
    mains = {f"my_pkg/{each}.py": "def main(): ...\n" for each in ("talker", "other")}
    inner = {"my_pkg/inner/__init__.py": WRONG, "my_pkg/inner/deep.py": "A = 1\n"}
    return python({**STARTED, **mains, **inner, **files})


def neighbour(text: str, files: dict[str, str | None] | None = None) -> Example:
    return python({**STARTED, "my_pkg/other.py": "def main(): ...\n", "my_pkg/talker.py": text + MAIN, **(files or {})})


def two_packages(text: str, other: str = "speech") -> Example:
    """A package that imports a module of another one of the workspace."""
    files = {f"a/{path}": each for path, each in python({"my_pkg/talker.py": text}).bad_files().items()}
    others = python({f"my_pkg/{other}.py": "A = 1\n"}).bad_files()
    files |= {
        f"b/{path.replace('my_pkg', 'your_pkg')}": each.replace("my_pkg", "your_pkg") for path, each in others.items()
    }
    return Example(on="", bad=files, good={})


TOOLS = MIXED_CMAKE.replace("package(my_pkg)", "package(my_pkg PACKAGE_DIR tools)")


def tools(cmake: str) -> Example:
    """A package with a folder of tools, which imports what is not declared."""
    files = {"package.xml": MIXED["package.xml"], "CMakeLists.txt": cmake, "tools/plot.py": "import scipy\n"}
    return Example(bad={**files, "tools/__init__.py": ""}, good={}, on="ament_cmake")


CASES = {
    "DEP101": (
        tools(TOOLS),
        tools(TOOLS.replace("ament_python_install_package(my_pkg PACKAGE_DIR tools)\n", "")),
        tools(
            MIXED_CMAKE.replace(
                "ament_python_install_package(my_pkg)", "install(DIRECTORY tools DESTINATION share/my_pkg)"
            )
        ),
        tools(
            MIXED_CMAKE.replace(
                "ament_python_install_package(my_pkg)", "install(PROGRAMS tools/plot.py DESTINATION lib/my_pkg)"
            )
        ),
    ),
    "DEP109": (
        importing("import my_pkg.speach\n"),
        *(started(files) for files in REACHING),
        importing("import my_pkg.speach.words\n"),
        importing("import my_pkg.speech.words\n"),
        importing("import my_pkg.nothing_alike\n"),
        importing("from .speach import GREETING\n"),
        importing("from . import speach, speech\n"),
        importing("from .. import speach\nfrom ..speach import a\n"),
        importing("from my_pkg.speech import said, say, GREETNG, __file__\n"),
        importing("from my_pkg.speech import *\n"),
        importing("try:\n    from my_pkg.speach import a\nexcept ImportError:\n    a = 1\n"),
        importing("def f():\n    from my_pkg.speach import a\n    return a\n"),
        importing("from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n    from my_pkg.speach import a\n"),
        importing("import sys\n\nsys.path.append('x')\nfrom my_pkg.speach import a\nfrom .speach import b\n"),
        importing("import rospy\nfrom my_pkg.speach import a\n"),
        importing("from my_pkg.speach import a\n", doc__conf_DOT_py="import sys\n\nsys.path.append('..')\n"),
        importing("from my_pkg.speach import a\n", test__test_a_DOT_py="import sys\n\nsys.path.append('..')\n"),
        importing("print(1)\n", test__test_a_DOT_py="import sys\n\nsys.path.append('..')\nimport my_pkg.speach\n"),
        importing("from my_pkg.speach import a\n", _DOT_gitignore="speach.py\n"),
        importing(
            "import my_pkg.speach\n", _DOT_gitmodules='[submodule "a"]\n\tpath = my_pkg/speach\n\turl = ../speach\n'
        ),
        importing("from my_pkg.speach import a\n", my_pkg__speach_DOT_pyx="a = 1\n"),
        importing("from my_pkg.speach import a\n", my_pkg__speach__a_DOT_txt="a = 1\n"),
        importing("from my_pkg._version import a\n"),
        importing("from my_pkg.msg import Status\nfrom my_pkg import srv\n"),
        python({**SPEECH, "my_pkg/talker.py": "import my_pkg.speach\n", "my_pkg/__init__.py": "__path__ = path()\n"}),
        python({**SPEECH, "my_pkg/talker.py": "import my_pkg.speech.a\n", "my_pkg/speech.py": "__path__ = path()\n"}),
        importing("from my_pkg.speech import a\n", my_pkg__speech_DOT_py="def __getattr__(name): ...\n"),
        importing("from my_pkg.speech import a\n", my_pkg__speech_DOT_py="import sys\nsys.modules[__name__] = 1\n"),
        importing(
            "from my_pkg.speech import a, B\n",
            my_pkg__speech_DOT_py="from .words import *\n",
            my_pkg__words_DOT_py="B = 1\n",
        ),
        importing("from my_pkg.speech import a\n", my_pkg__speech_DOT_py="from numpy import *\n"),
        importing("from my_pkg.speech import a\n", my_pkg__speech_DOT_py="from .speech import *\n"),
        importing("from my_pkg.speech import a\n", my_pkg__speech_DOT_py="if x:\n    a = 1\n"),
        importing("print(1)\n", test__test_a_DOT_py="from my_pkg.speach import a\n"),
        importing("print(1)\n", tools__a_DOT_py="from my_pkg.speach import a\n"),
        python({**SPEECH, **INNER, "my_pkg/talker.py": "from my_pkg.inner import A, deep, depp\n"}),
        python({**SPEECH, **INNER, "my_pkg/inner/deep.py": "from .speech import A\nfrom ..speach import A\n"}),
        python(
            {
                **SPEECH,
                "setup.py": SETUP_PY.replace("find_packages(exclude=['test'])", "found()"),
                "my_pkg/talker.py": "import my_pkg.speach\n",
            }
        ),
        Example(
            on="", bad={**MIXED, **SPEECH, "my_pkg/talker.py": "import my_pkg.speach\nimport my_pkg.core\n"}, good={}
        ),
        two_packages("from your_pkg.speach import A\n"),
        two_packages("from your_pkg.nothing_alike import A\n"),
        two_packages("from your_pkg.speech import B\n"),
        two_packages("from your_pkg.speech.words import B\n"),
        two_packages("from your_pkg.msgs import B\n", "msg"),
        two_packages("import sys\n\nsys.path.append('x')\nfrom your_pkg.speach import A\n"),
    ),
    "DEP110": (
        neighbour("import speech\n"),
        neighbour("from tools.words import a\nfrom tools import words\n", {"my_pkg/tools/words.py": "a = 1\n"}),
        neighbour("from tools.other import a\nfrom tools import say\n", {"my_pkg/tools/words.py": "a = 1\n"}),
        neighbour("from json.words import a\n", {"my_pkg/json/words.py": "a = 1\n"}),
        neighbour(
            "import sys\n\nsys.path.append('a')\nfrom tools import words\n", {"my_pkg/tools/words.py": "a = 1\n"}
        ),
        neighbour(
            "import speech\n",
            {
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main")).replace(
                    "['package.xml']),", "['package.xml']),\n        ('lib/' + package_name, ['my_pkg/speech.py']),"
                )
            },
        ),
        *(
            neighbour(text, {"setup.py": setup_py()})
            for text in ("import speech\n", "import speech\n\nif __name__ == '__main__':\n    print(speech)\n")
        ),
        *(
            neighbour("import speech\n", {"setup.py": setup_py(), "my_pkg/main.py": text})
            for text in (
                "import talker\n\nif __name__ == '__main__':\n    print(talker)\n",
                "from . import talker\n\nif __name__ == '__main__':\n    print(talker)\n",
                "import talker\n",
            )
        ),
        neighbour("import speech\n", {"setup.py": setup_py("scripts=['bin/run'],"), "bin/run": "#!/bin/sh\n"}),
        neighbour("from speech import GREETING as a\nfrom speech.words import b\n"),
        neighbour("from .speech import GREETING\n"),
        neighbour("from speech import GREETING, FAREWELL\n"),
        neighbour("import speech.words\n"),
        neighbour("from speech import *\n"),
        neighbour("import speech\n", {"requirements-dev.txt": "numpy\nspeech>=2\n"}),
        neighbour("import speech\n", {"requirements.txt": "pyspeech\nspeeches\n"}),
        neighbour("import speech\n", {"README.md": "Run:\n\n    pip install -U speech\n"}),
        neighbour("import speech\n", {"README.md": "It makes speech. Do not pip install speeches.\n"}),
        neighbour("import speech\n", {"notes.txt": "speech\npip install speech\n"}),
        neighbour("from greeting import GREETING\n"),
        neighbour("def f():\n    from speech import GREETING\n"),
        neighbour("try:\n    from speech import GREETING\nexcept ImportError:\n    pass\n"),
        neighbour("import sys\n\nsys.path.append('x')\nfrom speech import GREETING\n"),
        neighbour("", {"my_pkg/third.py": "from speech import GREETING\n"}),
        neighbour("from . import third\n", {"my_pkg/third.py": "from speech import GREETING\n"}),
        neighbour("from .third import a\n", {"my_pkg/third.py": "from speech import GREETING\n"}),
        neighbour("from speech import GREETING\n", {"speech.py": ""}),
        neighbour("from json import GREETING\n", {"my_pkg/json.py": ""}),
        neighbour("from cv2 import GREETING\n", {"my_pkg/cv2.py": ""}),
        neighbour("from speech import GREETING\n", {"package.xml": manifest("  <depend>speech</depend>\n")}),
        Example(on="", bad={**MIXED, **SPEECH, "my_pkg/talker.py": "import speech\n" + MAIN}, good={}),
    ),
}
