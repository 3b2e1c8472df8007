"""What exercises leave to be written: a comment names it, or asks for the code of a whole file."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

from .idioms_of_cmake import package

PROGRAM = "add_executable(talker src/talker.cpp)\n"
LISTENS = setup_py(scripts("listener = my_pkg.listener:main"))
IMPORTS = "from my_pkg.arm import move\n\n\ndef main():\n    move()\n"
USES = "# TODO: implement a class Listener\n\n\ndef main():\n    print(Listener())\n"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    # TODO: define the node of the talker
    return LaunchDescription([talker])
"""
BLANK = "from launch import LaunchDescription\n\n# Add your code below\n"

CASES = {
    "CMK125": (package(PROGRAM, {"src/talker.cpp": "#include <cstdio>\n\n// YOUR CODE HERE\n"}),),
    "SET102": (
        Example(good={}, bad={"setup.py": LISTENS, "my_pkg/listener.py": "import os\n\n# TODO: write main()\n"}),
    ),
    "DEP109": (
        Example(
            good={},
            bad={
                "setup.py": LISTENS,
                "my_pkg/listener.py": IMPORTS,
                "my_pkg/arm.py": "import os\n\n# YOUR CODE HERE\n",
            },
        ),
    ),
    "DEP117": (Example(good={}, bad={"setup.py": LISTENS, "my_pkg/listener.py": USES}),),
    "LCH013": (Example(good={}, bad={"package.xml": manifest(), "launch/a.launch.py": LAUNCH}),),
    "LCH001": (Example(good={}, bad={"package.xml": manifest(), "launch/a.launch.py": BLANK}),),
}
