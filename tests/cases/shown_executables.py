"""Nodes and scripts without an entry point, and entry points of packages of CMake: what no example shows."""

from __future__ import annotations

from rospkg_cli.example import INTERFACES_CMAKE, Example, manifest, scripts, setup_py
from rospkg_cli.rules.setup import set106_unregistered_main as set106
from rospkg_cli.rules.setup import set107_uninstalled_script as set107
from rospkg_cli.rules.setup import set108_broken_cmake_entry_point as set108

from .setups import plain, python

NODE = set106.NODE
TALKER = setup_py(scripts("talker = my_pkg.talker:main"))
NEEDS: dict[str, str | None] = {"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"), "setup.py": TALKER}
SCRIPT: dict[str, str | None] = {**NEEDS, "my_pkg/talker.py": NODE, "scripts/tool.py": plain(set107.NODE)}


def nodes(files: dict[str, str | None]) -> Example:
    return python({**NEEDS, "my_pkg/talker.py": NODE, "my_pkg/listener.py": NODE, **files})


def cmake(entries: str, files: dict[str, str | None] | None = None) -> Example:
    return Example(on="", bad={**set108.FILES, "setup.cfg": set108.CFG.format(entries), **(files or {})}, good={})


CASES = {
    "SET106": (
        nodes({"my_pkg/listener.py": NODE.partition("\n\n\nif")[0] + "\n"}),
        nodes({"my_pkg/listener.py": NODE.partition("\n\n\nif")[0] + "\n", "my_pkg/third.py": NODE}),
        nodes({"my_pkg/listener.py": NODE.replace("    main()", "    other()"), "my_pkg/third.py": NODE}),
        nodes({"setup.py": setup_py(scripts())}),
        *(nodes({"my_pkg/listener.py": None, f"my_pkg/{each}.py": NODE}) for each in ("talker_new", "talkers")),
        nodes({"setup.py": setup_py()}),
        nodes({"setup.py": setup_py(scripts("other-tool = my_pkg.talker:main"))}),
        nodes({"setup.py": setup_py(scripts("talker = my_pkg.talker"))}),
        nodes({"setup.py": TALKER.replace("console_scripts", "console_script")}),
        nodes({"setup.py": TALKER.replace("'talker = my_pkg.talker:main'", "entry()")}),
        nodes({"my_pkg/third.py": "from my_pkg.listener import main\n"}),
        nodes({"my_pkg/third.py": "from . import listener\n"}),
        nodes({"README.md": "`python3 listener.py`\n"}),
        nodes({"test/test_a.py": "'listener.py'\n"}),
        nodes({"my_pkg/listener.py": None, "my_pkg/listener_test.py": NODE}),
        nodes({"my_pkg/listener.py": None, "my_pkg/inner/__init__.py": "", "my_pkg/inner/a.py": NODE}),
        nodes({"launch/a.launch.xml": '<launch><node pkg="my_pkg" exec="listener"/></launch>\n'}),
        nodes({"my_pkg/listener.py": NODE.replace("import rclpy", "import rospy")}),
        *(nodes({"setup.py": setup_py(scripts()), "my_pkg/talker.py": None, "my_pkg/listener.py": None, **only})
          for only in ({"my_pkg/test_arm.py": NODE}, {"my_pkg/arm_demo.py": NODE}, {"my_pkg/test_arm_old.py": NODE},
                       {"my_pkg/test_arm.py": "import pytest\n" + NODE},
                       {"my_pkg/test_arm.py": NODE + "\n\ndef test_it():\n    main()\n"})),
    ),
    "SET107": (
        python(SCRIPT),
        python({**SCRIPT, "README.md": "`scripts/tool.py`\n"}),
        python({**SCRIPT, ".gitignore": "scripts/\n"}),
        python({**SCRIPT, "scripts/tool.py": None, "tools/tool.py": NODE, "tool.py": NODE, "nodes/a/b.py": NODE}),
        python({**SCRIPT, "scripts/tool.py": NODE.replace("rclpy", "numpy")}),
        python({**SCRIPT, "scripts/tool.py": NODE.partition("\n\n\nif")[0] + "\n"}),
        python({**SCRIPT, "scripts/tool.py": "import rclpy\n\nif __name__ == '__main__':\n    main()\n"}),
        python({**SCRIPT, "setup.py": setup_py("scripts=['scripts/tool.py'],")}),
        python({**SCRIPT, "setup.py": setup_py("scripts=found(),")}),
        python({**SCRIPT, "setup.py": setup_py("entry_points={'ros2cli.command': ['a = my_pkg.talker:A']},")}),
    ),
    "SET108": (
        cmake("talker = my_pkg.unlike:main\n    other = your_pkg.talker:main\n    third = my_pkg.talker:main.inner"),
        cmake("talker = my_pkg.taker:main", {"my_pkg/taker.cpp": ""}),
        cmake("talker = my_pkg.talker:mian", {"my_pkg/talker.py": "def __getattr__(name): ...\n"}),
        cmake(
            "talker = my_pkg.taker:main", {"CMakeLists.txt": set108.CMAKE + INTERFACES_CMAKE + "include(${OTHER})\n"}
        ),
        python({"setup.py": setup_py(scripts("talker = my_pkg.taker:main")), "my_pkg/talker.py": "def main(): ...\n"}),
        cmake("talker\n    a = my_pkg.talker:main b = my_pkg.talker:main\n    c = my_pkg.talker"),
        cmake("talker", {"CMakeLists.txt": set108.CMAKE.replace(" SCRIPTS_DESTINATION lib/my_pkg", "")}),
        cmake("talker", {"CMakeLists.txt": set108.CMAKE.replace("SCRIPTS_DEST", "SETUP_CFG x.cfg SCRIPTS_DEST")}),
        cmake("talker", {"CMakeLists.txt": "if(X)\n" + set108.CMAKE + "endif()\n"}),
        *(cmake(f"talker = my_pkg.taker:main{more}", {"README.md": "The talker is in `my_pkg/talker.py`.\n", **files})
          for more in ("", "\n    other = my_pkg.talker:main")
          for files in ({}, {"launch/a.launch.xml": '<launch><node pkg="my_pkg" exec="talker"/></launch>\n'},
                        {"run.sh": "ros2 run my_pkg talker &\n"}, {"run.sh": "ros2 run my_pkg talker_old\n"})),
    ),
}  # fmt: skip
