"""Functions of a launch file that nothing there names."""

from __future__ import annotations

import pytest

from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.package.launch.uncalled_functions import uncalled_functions
from rospkg_cli.source import Source

ENTRY = "def generate_launch_description():\n    return {}\n"
OTHER = "def f():\n    pass\n"


def found(text: str) -> list[str]:
    file = parse_python(Source("a.launch.py", text))
    return [file.source.slice(span).partition("(")[0].removeprefix("def ") for span in uncalled_functions(file)]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (OTHER + ENTRY, ["f"]),
        (OTHER, []),
        (OTHER + ENTRY.replace("{}", "f()"), []),
        (OTHER + ENTRY.replace("{}", "OpaqueFunction(function=f)"), []),
        (OTHER + ENTRY.replace("{}", "call('f')"), []),
        (OTHER + ENTRY.replace("{}", "getattr(a, b)()"), []),
        (OTHER.replace("pass", "f()") + ENTRY, ["f"]),
        (OTHER + "def g():\n    f()\n" + ENTRY, ["g", "f"]),
        (OTHER + ENTRY.replace("return", "if False:\n        f()\n    return"), ["f"]),
        ("@made\n" + OTHER + ENTRY, []),
        ("class A:\n    def m(self):\n        pass\n    def __len__(self):\n        pass\n" + ENTRY, ["m"]),
        ("class A:\n    def m(self):\n        pass\n" + ENTRY.replace("{}", "A().m()"), []),
        ("class A(B):\n    def m(self):\n        pass\n" + ENTRY, []),
        ("async def f():\n    pass\n" + ENTRY, ["async def f"]),
    ],
)
def test_functions_that_nothing_names(text: str, names: list[str]) -> None:
    assert sorted(found(text)) == sorted(names)
