"""PLG003: plugins that a comment or a page has people write, or that a comment says nothing reads."""

from __future__ import annotations

import pytest

from rospkg_cli.example import Example
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003
from rospkg_cli.testing import lint_files

FILES = Example(on="ament_cmake", bad=plg003.FILES, good={}).bad_files()
CONFIG = """\
planner_server:
  ros__parameters:
    planner_plugins: [GridBased]
{}    GridBased:
{}      plugin: {}
"""


def level(block: str = "", value: str = "", name: str = "my_pkg/Round", page: str = "") -> str:
    files = {**FILES, "config/nav2.yaml": CONFIG.format(block, value, name), "README.md": page}
    (only,) = lint_files(files, ["PLG003"]).findings
    return only.severity.value


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        ("# unused", "info"),
        ("# not supported yet", "info"),
        ("# TODO: implement Round", "info"),
        ("# round", "warning"),
    ],
)
def test_what_a_comment_says(comment: str, expected: str) -> None:
    assert level(value=f"      {comment}\n") == expected
    assert level(name=f"my_pkg/Round  {comment}") == expected


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("Exercise: write the plugin `my_pkg/Round`.\n", "info"),
        ("Implement a class `Round`.\n", "info"),
        ("The plugin `my_pkg/Round` plans.\n", "warning"),
        ("Write `my_pkg/Rounder`.\n", "warning"),
    ],
)
def test_a_page_that_has_people_write_it(page: str, expected: str) -> None:
    assert level(page=page) == expected


def test_a_slip_stays() -> None:
    assert level(name="my_pkg::Planner") == "warning"
    assert level(name="my_pkg::Planner", page="Write a plan.\n") == "warning"
