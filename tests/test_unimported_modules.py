"""What is wrong in a module of a library is met by who imports that module, and not by who takes other parts of it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

LIBRARY = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(),
    "my_pkg/__init__.py": "from .words import GREETING\n",
    "my_pkg/words.py": "GREETING = 'hello'\n",
    "my_pkg/tools/__init__.py": "from .gone import polish\n",
    "my_pkg/tools/more.py": "from . import polish\n",
}
USES = {
    "": "warning",
    "from my_pkg import GREETING": "info",
    "from my_pkg.tools import polish": "warning",
    "from my_pkg import GREETING, tools": "warning",
    "import my_pkg.tools.more": "warning",
}


def level(use: str, more: dict[str, str]) -> list[str]:
    files = {f"a/{path}": text for path, text in {**LIBRARY, **more}.items()}
    user = existing_files(BACKDROPS["ament_python"])
    files |= {f"b/{path.replace('my_pkg', 'user')}": text.replace("my_pkg", "user") for path, text in user.items()}
    files["b/user/talker.py"] = f"{use}\n"
    return [
        each.severity.value for each in lint_files(files, ["DEP109"]).findings if "`my_pkg.tools.gone`" in each.message
    ]


@pytest.mark.parametrize("use", USES)
def test_an_import_that_fails(use: str) -> None:
    assert level(use, {}) == [USES[use]]


@pytest.mark.parametrize(
    "more",
    [
        {"README.md": "Write `from my_pkg.tools import polish`.\n"},
        {"my_pkg/words.py": "from .tools import polish\n\nGREETING = polish('hello')\n"},
        {"my_pkg/start.py": "from .tools import polish\n\nif __name__ == '__main__':\n    polish('hello')\n"},
        {"test/test_tools.py": "from my_pkg.tools import polish\n\n\ndef test_it():\n    polish('hello')\n"},
    ],
)
def test_what_else_comes_to_the_module(more: dict[str, str]) -> None:
    assert level("from my_pkg import GREETING", more)[:1] != ["info"]


STUB = "class Brain(Node):\n    pass\n"


@pytest.mark.parametrize("text", [STUB, "import rclpy\n\nrclpy.intt()\n"])
@pytest.mark.parametrize(
    ("more", "level"),
    [
        ({}, "warning"),
        ({"README.md": "The brain is still to come.\n"}, "warning"),
        ({"README.md": "    python3 my_pkg/brain.py\n"}, "error"),
        ({"README.md": "Write `from my_pkg.brain import Brain`.\n"}, "error"),
        ({"my_pkg/__init__.py": "from .brain import Brain\n"}, "error"),
        ({"test/test_brain.py": "from my_pkg.brain import Brain\n\n\ndef test_it():\n    Brain()\n"}, "error"),
        ({"setup.py": setup_py(scripts("brain = my_pkg.brain:Brain"))}, "error"),
    ],
)
def test_no_start_ends_in_a_module_that_nothing_imports(text: str, more: dict[str, str], level: str) -> None:
    own = {"my_pkg/__init__.py": "", "my_pkg/brain.py": text, "package.xml": manifest("  <depend>rclpy</depend>\n")}
    found = lint_files({**existing_files(BACKDROPS["ament_python"]), **own, **more}, ["DEP117", "DEP120"]).findings
    assert [each.severity.value for each in found] == [level]
