"""DEP118: paths for a machine that code asks for first, for another host, and defaults that each call replaces."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {**existing_files(BACKDROPS["ament_python"]), "config/a.yaml": "a: 1\n"}
PLACE = "'/home/ada/ws/src/my_pkg/config/a.yaml'"


def level(body: str, rest: str = "") -> str:
    """Return the level of a path in the body of a program, which opens `path`, or in what stands around it."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    text = f"import os\nimport socket\nimport subprocess\n\n{rest}\n\ndef main():\n{lines}    open(path)\n"
    files = {**PACKAGE, "setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/talker.py": text}
    (found,) = lint_files(files, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f"path = {PLACE}", "warning"),
        (f"path = {PLACE} if socket.gethostname() == 'ada' else '/etc/a'", "info"),
        (f"host = socket.gethostname()\nif host == 'ada':\n    path = {PLACE}\nelse:\n    path = '/etc/a'", "info"),
        (f"path = {{'ada': {PLACE}}}[os.environ['USER']]", "info"),
        (f"path = {{'ada': {PLACE}}}.get(os.getenv('HOSTNAME'))", "info"),
        (f"path = {PLACE} if os.environ['MODE'] == 'ada' else '/etc/a'", "warning"),
        (f"host = socket.gethostname()\npath = {PLACE}", "warning"),
        (f"path = {{'ada': {PLACE}}}['ada']", "warning"),
    ],
)
def test_a_path_that_is_chosen_by_the_machine(body: str, expected: str) -> None:
    assert level(body) == expected


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("'ssh', 'ada@robot', 'cat', {}", "info"),
        ("'/usr/bin/scp',\n        'ada@robot',\n        {}", "info"),
        ("'cat', {}", "warning"),
        ("'ssh', 'robot'], {}, [", "warning"),
    ],
)
def test_a_path_on_another_host(words: str, expected: str) -> None:
    assert level(f"path = run([{words.format(PLACE)}])") == expected


@pytest.mark.parametrize(
    ("calls", "expected"),
    [
        ("path = load('a')", "info"),
        ("path = load(path='a')", "info"),
        ("load('a')\npath = load()", "warning"),
        ("path = load(*names())", "warning"),
        ("load('a')\npath = call(load)", "warning"),
    ],
)
def test_a_default_that_every_call_replaces(calls: str, expected: str) -> None:
    assert level(calls, f"def load(path={PLACE}):\n    return open(path)\n") == expected


@pytest.mark.parametrize(("call", "expected"), [("Loader('a')", "info"), ("Loader()", "warning")])
def test_a_default_of_a_constructor(call: str, expected: str) -> None:
    rest = f"class Loader:\n    def __init__(self, path={PLACE}, *, mode='r'):\n        self.file = open(path, mode)\n"
    assert level(f"path = {call}", rest) == expected
