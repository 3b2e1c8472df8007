"""Data that setup.py leaves out, by who names it: a page, a script, a path in the source, or nobody (SET2xx)."""

from __future__ import annotations

from rospkg_cli.example import Example, setup_py
from rospkg_cli.rules.setup import set204_empty_glob as set204
from rospkg_cli.rules.setup import set207_file_not_installed as set207

from .setups import python

LAUNCH = {"launch/arm.launch.xml": set207.LAUNCH, "README.md": ""}
NARROW = "glob('launch/*.launch.xml')"
THREE = {f"launch/{each}.launch.xml": set207.LAUNCH for each in "abc"}
TWO = "['launch/a.launch.xml', 'launch/b.launch.xml']"


def lint(*parts: dict[str, str], setup: str = "") -> Example:
    return python({**{name: text for part in parts for name, text in part.items()}, "setup.py": setup or setup_py()})


CASES = {
    "SET204": tuple(
        lint({"maps/office.pgm": "", **files}, setup=set204.launch("glob('maps/*.png')"))
        for files in ({}, {"my_pkg/a.py": "get_package_share_directory('my_pkg') + '/maps/office.pgm'\n"})
    ),
    "SET206": tuple(
        lint(LAUNCH, files)
        for files in (
            {"README.md": "ros2 launch my_pkg arm.launch.xml\n"},
            {"README.md": "ros2 launch launch/arm.launch.xml\n"},
            {"README.md": "cd launch\nros2 launch leg.launch.xml\n"},
            {"run.sh": "ros2 launch ./arm.launch.xml sim:=true\n"},
        )
    ),
    "SET207": (
        *(
            lint(set207.FILES, {"README.md": "", **files}, setup=set207.launch(NARROW))
            for files in ({}, {"run.sh": "ros2 launch my_pkg arm_launch.xml\n"})
        ),
        *(
            lint(THREE, files, setup=set207.launch(TWO))
            for files in ({}, {"docs/start.md": "`ros2 launch my_pkg c.launch.xml`\n"})
        ),
    ),
}
