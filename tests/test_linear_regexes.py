"""Expressions on text of a package: one pass, however hostile it is. A quadratic one would take minutes here."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.robot_parameters import ROBOT_FILE
from rospkg_cli.edits.toml import candidate_entries
from rospkg_cli.example import manifest, setup_py
from rospkg_cli.languages.cmake.condition_context import FROM_OUTSIDE
from rospkg_cli.languages.python.evaluate.formatting import PERCENT
from rospkg_cli.package.interfaces.comments import units_in
from rospkg_cli.package.plugins.plugin_uses import without_comments
from rospkg_cli.testing import lint_files

LONG = 300_000


@pytest.mark.parametrize("name", ["A_B", "a_B", "rclcpp_VERSION", "a_B_C_", "CMAKE_BUILD_TYPE", "A1_2"])
def test_names_from_outside(name: str) -> None:
    assert FROM_OUTSIDE.fullmatch(name)


@pytest.mark.parametrize("name", ["A", "a_b", "_", "a_B1_c", "_A_", "A_" * LONG + "!", "_" * LONG, "_A" * LONG + "_b"])
def test_names_that_are_no_others(name: str) -> None:
    assert not FROM_OUTSIDE.fullmatch(name)


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("speed  [m/s]", [("  [m/s]", "m/s")]),
        ("[a[b] x, [c,d] []", [("[a[b]", "a[b")]),
        ("a [m\ns] [b]", [(" [m\ns]", "m\ns"), (" [b]", "b")]),
        ("[" * LONG, []),
        (" " * LONG, []),
        ("[," * LONG + "]", []),
    ],
)
def test_units_in_comments(text: str, units: list[tuple[str, str]]) -> None:
    assert [(unit.whole, unit.inside) for unit in units_in(text)] == units


def test_blanks_before_a_key_of_toml() -> None:
    text = "a = [" + " " * LONG + "\n" + " " * LONG + "x\n" + " , k = 'a'"
    assert [text[whole.start : whole.end] for _, whole in candidate_entries(text, "k")] == [" , k = 'a'"]


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("a<!-- b -->c", "a          c"),
        ("<!----><a/>", "       <a/>"),
        ("<a/><!-- open", "<a/><!-- open"),
        ("<!--" * LONG, "<!--" * LONG),
    ],
)
def test_comments_of_a_robot_description(text: str, shown: str) -> None:
    assert without_comments(text) == shown


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("xacro robot.urdf.xacro", ["robot.urdf.xacro"]),
        ("/a/b.urdf x.xacro", ["b.urdf", "x.xacro"]),
        ("a" * LONG, []),
        ("a." * LONG, []),
    ],
)
def test_robot_files_in_a_command(text: str, names: list[str]) -> None:
    assert ROBOT_FILE.findall(text) == names


def test_keys_in_a_format() -> None:
    assert PERCENT.fullmatch("%(name)s")
    assert sum(1 for _ in PERCENT.finditer("%(" * LONG)) == LONG


@pytest.mark.parametrize("name", ["license", "maintainer", "maintainer_email"])
def test_endless_texts_of_setup_py(name: str) -> None:
    findings = lint_files({"package.xml": manifest(), "setup.py": setup_py(f"{name}=' ' * {LONG} + 'x',")}, ["SET403"])
    assert not findings.crashes
