"""A component that a source registers, CMake does not, and a launch file loads: one finding, where the cause is."""

from __future__ import annotations

import pytest

from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.testing import lint_files

LAUNCH = lch011.BAD.replace("«my_pkg::Taker»", "my_pkg::Listener")
SOURCE = lch011.FILES["src/talker.cpp"] + "RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Listener)\n"


def lint(**changed: str) -> list[tuple[str, str]]:
    files = {**lch011.FILES, "launch/a.launch.xml": LAUNCH, "src/talker.cpp": SOURCE}
    files |= {name.replace("__", "/").replace("_DOT_", "."): text for name, text in changed.items()}
    return [(each.code, each.severity.value) for each in lint_files(files, ["LCH011", "CMK108"]).findings]


def test_what_a_source_registers_is_told_there_as_an_error() -> None:
    assert lint() == [("CMK108", "error")]


@pytest.mark.parametrize(
    "launch",
    ["<launch/>", LAUNCH.replace("my_pkg", "other"), LAUNCH.replace("Listener", "Talker")],
)
def test_what_no_launch_file_loads_is_a_warning(launch: str) -> None:
    found = lint(launch__a_DOT_launch_DOT_xml=launch)
    assert ("CMK108", "warning") in found


def test_what_no_source_registers_is_told_where_it_is_loaded() -> None:
    assert lint(src__talker_DOT_cpp=lch011.FILES["src/talker.cpp"]) == [("LCH011", "error")]
