"""Paths in a home folder that a comment or a page tells people to write anew."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py

MAP = "/home/ada/ws/src/my_pkg/photos"
SET = f"folder = '{MAP}'"
TALKER = "def main():\n    print(folder)\n"
README = "# My package\n\n{}\n"


def started(settings: str, **files: str) -> Example:
    """Return a node with settings above its function."""
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    code = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "photos/a.png": ""}
    return Example(bad={**code, "my_pkg/talker.py": f"{settings}\n\n\n{TALKER}", **named}, good={})


def by_hand(settings: str) -> Example:
    """Return a script that nothing installs, and that a page tells to start."""
    script = {"scripts__convert_DOT_py": f"{settings}\n\nprint(folder)\n"}
    return started("folder = ''", README_DOT_md=README.format("Start it: python3 scripts/convert.py"), **script)


CASES = {
    "DEP118": (
        started(f"# Change the path here\n{SET}"),
        started(f"{SET}  # change this"),
        started(f"# TODO: change\n{SET}"),
        started(f"# path to your photos folder\nname = 'a'\n{SET}"),
        started(f"# Cambia esta ruta si es necesario\n{SET}"),
        started(f"# 修改为你自己的路径\n{SET}"),
        started(f"# 查找照片\n{SET}"),
        started(f"# Change this to your folder\n\n{SET}"),
        started(f"# Change this\nimport os\n{SET}"),
        started(f"# change directory to the photos\n{SET}"),
        started(f"# Set the path of the photos\n{SET}"),
        by_hand(f"# ****\n# set paths\n# ****\n{SET}"),
        by_hand(f"# where the photos are\n{SET}"),
        started(SET, README_DOT_md=README.format("1. Change the path in `talker.py`.")),
        started(SET, README_DOT_md=README.format("1. `talker.py` changes the path.")),
        started(SET, CHANGELOG_DOT_md=README.format("* change the path in talker.py")),
    ),
}
