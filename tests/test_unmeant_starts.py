"""What nobody is meant to start: a program whose text says so, or the `main` of a module that is there for others."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

BASE = """\
import rclpy
from rclpy.node import Node


class Filter(Node):
    def __init__(self, name):
        super().__init__(name)


def main():
    {doc}
    rclpy.init()
    rclpy.spin(Filter())


if __name__ == '__main__':
    main()
"""
HEIR = """\
import rclpy
from my_pkg.base import Filter


class Red(Filter):
    def __init__(self):
        super().__init__('red')


def main():
    rclpy.init()
    rclpy.spin(Red())
"""
FILES = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("base = my_pkg.base:main", "red = my_pkg.red:main")),
    "my_pkg/base.py": BASE.format(doc="print()"),
    "my_pkg/red.py": HEIR,
    "README.md": "`ros2 run my_pkg red`\n",
}
SPARE = "; nothing here starts this program, whose module is there for others"
TOLD = "; its own text says that it is not to be started"


def test_the_start_of_a_base_class_that_nothing_starts() -> None:
    found = lint_files(FILES, ["DEP120"]).findings
    assert [(each.severity.value, each.message.partition("TypeError")[2]) for each in found] == [("info", SPARE)]


@pytest.mark.parametrize(
    "changed",
    [
        {"README.md": "`ros2 run my_pkg base` and `ros2 run my_pkg red`\n"},
        {
            "my_pkg/red.py": HEIR.replace("rclpy.init()", "base.main()").replace(
                "from my", "from my_pkg import base\nfrom my"
            )
        },
        {
            "my_pkg/red.py": HEIR.replace("import Filter", "import Filter, main as begin").replace(
                "rclpy.init()", "begin()"
            )
        },
    ],
)
def test_a_base_class_that_is_started(changed: dict[str, str]) -> None:
    findings = lint_files({**FILES, **changed}, ["DEP120"]).findings
    assert [each.severity.value for each in findings] != ["info"]


def test_beside_nothing_that_is_started_it_is_loud() -> None:
    findings = lint_files({**FILES, "README.md": "\n"}, ["DEP120"]).findings
    assert [each.severity.value for each in findings] == ["error"]


ALONE = {**FILES, "README.md": "\n", "my_pkg/red.py": None}


@pytest.mark.parametrize(
    ("said", "is_told"),
    [
        ("DO NOT RUN this node.", True),
        ("Don't run this directly.", True),
        ("Not meant to be started.", True),
        ("This should not be launched", True),
        ("Do not run this as root.", False),
        ("Should not be run while the arm moves.", False),
        ("Do not use this with other filters.", False),
        ("Run the node.", False),
    ],
)
@pytest.mark.parametrize("place", ["in the function", "above it", "at the top"])
def test_what_a_text_says_of_the_start(said: str, is_told: bool, place: str) -> None:
    text = BASE.format(doc=f'"""{said}"""' if place == "in the function" else "print()")
    text = text.replace("def main", f"# {said}\ndef main") if place == "above it" else text
    text = f"#!/usr/bin/env python3\n# {said}\n{text}" if place == "at the top" else text
    files = {name: each for name, each in {**ALONE, "my_pkg/base.py": text}.items() if each is not None}
    files["setup.py"] = setup_py(scripts("base = my_pkg.base:main"))
    found = lint_files(files, ["DEP120"]).findings
    assert [each.severity.value for each in found] == ["info" if is_told else "error"]
    assert [each.message.endswith(TOLD) for each in found] == [is_told]
    files["README.md"] = "`ros2 run my_pkg base`\n"
    assert [each.severity.value for each in lint_files(files, ["DEP120"]).findings] == ["error"]
