"""A bare import of a neighbour works where a text puts the folder on PYTHONPATH."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/speech.py": "GREETING = 'hello'\n",
    "my_pkg/talker.py": "from speech import GREETING\n\n\ndef main():\n    print(GREETING)\n",
}
WHOLE = {f"src/my_pkg/{path}": text for path, text in PACKAGE.items()}
SET_ENV = '<launch><set_env name="{}" value="$(find-pkg-prefix my_pkg)/lib"/></launch>\n'


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("run.sh", "export PYTHONPATH=$PYTHONPATH:$PWD/src/my_pkg/my_pkg\n", "info"),
        ("run.sh", "export PYTHONPATH=/opt/other_pkg:$PYTHONPATH\n", "error"),
        ("run.sh", "export PYTHONPATH=/ws/src/my_pkg/vendor:$PYTHONPATH\n", "error"),
        ("README.md", "Type `export PYTHONPATH=~/ws/src/my_pkg/my_pkg`.\n", "info"),
        ("Dockerfile", 'FROM ros:jazzy\nENV PYTHONPATH="/ws/src/my_pkg/my_pkg/:${PYTHONPATH}"\n', "info"),
        ("Dockerfile", 'FROM ros:jazzy\nENV PATH="/ws/src/my_pkg/my_pkg:${PATH}"\n', "error"),
        (".env", "PYTHONPATH=./src/my_pkg/my_pkg\n", "info"),
        ("src/my_pkg/launch/talk.launch.xml", SET_ENV.format("PYTHONPATH"), "info"),
        ("src/my_pkg/launch/talk.launch.xml", SET_ENV.format("WORDS"), "error"),
    ],
)
def test_who_sets_the_path(path: str, text: str, expected: str) -> None:
    found = lint_files({**WHOLE, path: text}, ["DEP110"]).findings
    assert [each.severity.value for each in found] == [expected]
    assert (found[0].fix is None) == (expected == "info")
