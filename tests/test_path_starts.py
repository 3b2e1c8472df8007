"""A bare import of a neighbour works where the pages and scripts of a repository start the file by its path."""

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
TEXTS = {
    "python3 src/my_pkg/my_pkg/talker.py\n": "info",
    "./venv/bin/python install/my_pkg/lib/python3.12/site-packages/my_pkg/talker.py\n": "info",
    "python3 -u talker.py\n": "info",
    "python3 other_talker.py\n": "error",
    "python3 talker.pyc\n": "error",
    "# python3 talker.py\n": "error",
    "python3 talker.py\nros2 run my_pkg talker\n": "error",
    "python3 talker.py\nros2 launch my_pkg talk.launch.py\n": "error",
    "python3 talker.py\nros2 run my_pkg_more talker\n": "info",
    "ros2 run my_pkg talker\n": "error",
    'CMD ["python3", "-u", "/ws/src/my_pkg/my_pkg/talker.py"]\n': "info",
    'CMD ["python3", "/ws/src/my_pkg/my_pkg/other_talker.py"]\n': "error",
    'CMD ["ros2", "run", "my_pkg", "talker"]\nENTRYPOINT ["python3", "talker.py"]\n': "error",
}


@pytest.mark.parametrize("text", TEXTS)
def test_who_starts_the_file(text: str) -> None:
    found = lint_files({**PACKAGE, "scripts/run.sh": text}, ["DEP110"]).findings
    assert [each.severity.value for each in found] == [TEXTS[text]]
    assert (found[0].fix is None) == (TEXTS[text] == "info")


def test_a_script_above_the_package() -> None:
    files = {f"src/my_pkg/{path}": text for path, text in PACKAGE.items()}
    files["scripts/talk/run.sh"] = "python3 src/my_pkg/my_pkg/talker.py\n"
    assert [each.severity.value for each in lint_files(files, ["DEP110"]).findings] == ["info"]
