"""DEP118: nobody imports a script of a package without programs that works in a loop as soon as it is imported."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

USER = {
    f"b/{path.replace('my_pkg', 'user')}": text.replace("my_pkg", "user")
    for path, text in existing_files(BACKDROPS["ament_python"]).items()
}
USER["b/package.xml"] = USER["b/package.xml"].replace("</package>", "  <depend>my_pkg</depend>\n</package>")
LIBRARY = {
    **{f"a/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()},
    "a/setup.py": setup_py(),
    "a/data/a.png": "",
    "a/my_pkg/words.py": "def say():\n    return 'hello'\n",
}
SCRIPT = (
    "from glob import glob\n\nfolder = '/home/ada/ws/src/my_pkg/data'\nfor each in glob(folder):\n    print(each)\n"
)
DEFINES = f"{SCRIPT}\n\ndef say():\n    return folder\n"
PLAIN = "folder = '/home/ada/ws/src/my_pkg/data'\n"
SHOW = "a/my_pkg/show.py"


def level(files: dict[str, str]) -> str:
    (found,) = lint_files({**LIBRARY, **USER, **files}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({SHOW: SCRIPT}, "info"),
        ({SHOW: SCRIPT.replace("for each", "if folder:\n  for each").replace("    print", "      print")}, "info"),
        ({SHOW: DEFINES}, "warning"),
        ({SHOW: PLAIN}, "warning"),
        ({SHOW: SCRIPT, "a/README.md": "Run `python3 my_pkg/show.py`.\n"}, "warning"),
        ({SHOW: SCRIPT, "a/my_pkg/words.py": "from . import show\n"}, "warning"),
        ({SHOW: SCRIPT, "b/user/talker.py": "from my_pkg.show import folder\n"}, "warning"),
        ({SHOW: SCRIPT, "b/user/talker.py": "from my_pkg import show\n"}, "warning"),
        ({SHOW: SCRIPT, "a/setup.py": setup_py(scripts("show = my_pkg.show:main"))}, "warning"),
        ({"a/my_pkg/__init__.py": SCRIPT}, "warning"),
    ],
)
def test_a_script_in_a_library(files: dict[str, str], expected: str) -> None:
    assert level(files) == expected


@pytest.mark.parametrize(("page", "expected"), [("", "info"), ("Run `python3 my_pkg/test_show.py`.\n", "warning")])
def test_a_script_that_is_called_like_a_test(page: str, expected: str) -> None:
    assert level({"a/my_pkg/test_show.py": SCRIPT, "a/README.md": page}) == expected
