"""Annotations that Python never evaluates end no run: those of variables in a function, and all where they wait."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.rules.depends import dep120_unknown_rclpy_name as dep120
from rospkg_cli.testing import lint_files

HEAD = "from typing import TYPE_CHECKING, Optional\n"
LATER = "from __future__ import annotations\n"


def levels(lines: str, head: str = "", top: str = "", codes: tuple[str, ...] = ("DEP117", "DEP120")) -> list[str]:
    body = "".join(f"        {line}\n" for line in lines.split("\n"))
    text = dep120.NODE.replace("        self.create_timer(1.0, self.tick)\n", body)
    text = f"{head}{HEAD}{text.replace('class Talker', f'{top}class Talker')}"
    files = {**existing_files(BACKDROPS["ament_python"]), **dep120.FILES, "my_pkg/talker.py": text}
    return [each.severity.value for each in lint_files(files, list(codes)).findings]


@pytest.mark.parametrize(
    "lines",
    [
        "self.pub: rclpy.Publisher = None",
        "self.pub: Optional[rclpy.Publisher] = None",
        "pub: rclpy.Publisher = None",
        "pub: Missing\npub = 1",
        "for each in ():\n    pub: rclpy.Publisher",
        "if TYPE_CHECKING:\n    print(missing, rclpy.Publisher)",
    ],
)
def test_what_says_the_type_of_a_variable_in_a_function_is_not_evaluated(lines: str) -> None:
    assert levels(lines) == []


@pytest.mark.parametrize(
    "lines", ["class Held:\n    pub: rclpy.Publisher = None", "def inner(pub: rclpy.Publisher):\n    pass"]
)
def test_what_is_evaluated_as_a_class_or_function_is_made_is_told(lines: str) -> None:
    assert levels(lines) == ["info"]
    assert levels(lines, LATER) == []


def test_the_value_beside_a_type_is_told() -> None:
    assert levels("self.pub: object = rclpy.Publisher") == levels("self.pub: object = rclpy.Publisher", LATER)
    assert levels("self.pub: object = rclpy.Publisher") == ["error"]


def test_what_the_top_level_evaluates_is_told_until_it_waits() -> None:
    top = "pub: rclpy.Publisher = None\n\n\n"
    assert levels("pass", top=top) == ["warning"]
    assert levels("pass", LATER, top=top) == []
