"""Expressions on text of a package: one pass, however hostile it is. A quadratic one would take minutes here."""

from __future__ import annotations

import pytest

from rospkg_cli.edits.toml import candidate_entries
from rospkg_cli.languages.cmake.condition_context import FROM_OUTSIDE
from rospkg_cli.package.interfaces.comments import units_in

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
