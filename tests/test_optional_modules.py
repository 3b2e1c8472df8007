"""A module that functions alone import is met where these imports are: an optional part of a library, as a rule."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/large.py": "from .external.net import Net\n\n\ndef make():\n    return Net()\n",
}
MAIN = "from my_pkg.models import model\n\n\ndef main():\n    print(model('small'))\n"
LAZY = "def model(kind):\n    {}from .large import make\n    {}return make()\n"
BRANCH = "if kind == 'large':\n        if kind:\n            "


@pytest.mark.parametrize(
    ("models", "level"),
    [
        (LAZY.format("", ""), "error"),
        (LAZY.format(BRANCH, "        "), "info"),
        ("from .large import make\n\n\ndef model(kind):\n    return make()\n", "error"),
    ],
)
def test_what_an_optional_module_imports(models: str, level: str) -> None:
    files = {**PYTHON, "my_pkg/talker.py": MAIN, "my_pkg/models.py": models}
    (found,) = lint_files(files, ["DEP109"]).findings
    assert found.location.path == "my_pkg/large.py"
    assert found.severity.value == level
