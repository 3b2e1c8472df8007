"""docs/coming-from.md: its options are taken, and what other tools find is found by the rules that it names."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import pytest
from in_process import run_here

from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.coming_from import DATA, ROWS, faulty

TEXT = (Path(__file__).parents[1] / "docs/coming-from.md").read_text(encoding="utf-8")
PARTS = {tool: TEXT.partition(f"\n## {tool}\n")[2].partition("\n## ")[0] for tool in DATA["tools"]}
NOT_FINDINGS = ("Its step", "Its message", "Its option", "`ament_xmllint`", "`-", "`#", "without ", "other XML files")
FOR_ROS_2 = [pytest.param(tool, row, id=row["row"]) for tool, row in ROWS if tool != "catkin_lint"]


def rows_of(tool: str) -> list[str]:
    """Return the rows about what a tool finds."""
    rows = re.findall(r"^\| (?!---)(?!\|)(.*)$", PARTS[tool], re.MULTILINE)
    return [row for row in rows if not row.startswith(NOT_FINDINGS)]


@pytest.mark.parametrize("tool, row", FOR_ROS_2)
def test_a_fault_of_another_tool_is_found_by_a_rule_of_its_row(tool: str, row: dict[str, Any]) -> None:
    [line] = [line for line in rows_of(tool) if row["row"] in line]
    assert lint_files(faulty(row), re.findall(r"\[(\w+\d+)\]", line)).findings


@pytest.mark.parametrize("tool", DATA["tools"])
def test_each_row_has_a_fault_that_its_tool_was_run_on(tool: str) -> None:
    faults = [row["row"] for name, row in ROWS if name == tool]
    words = re.compile(r"[\w-]+") if tool == "catkin_lint" else re.compile(".+")
    for line in rows_of(tool):
        cell = re.sub(r" \(.*\)", "", line.partition(" |")[0])
        for part in words.findall(cell):
            assert any(part == fault or (fault in cell and " " in cell) for fault in faults), part
        assert set(re.findall(r"\[(\w+\d+)\]", line)) <= {rule.code for rule in all_rules()}
    assert DATA["tools"][tool]["title"] in TEXT


def test_options_of_ros2_pkg_create_are_taken(tmp_path: Path) -> None:
    done = run_here(
        "new", "my_pkg", "--build-type", "ament_cmake", "--node-name", "talker", "--dependencies", "rclcpp,std_msgs",
        "--description", "Talks", "--license", "MIT", "--maintainer-name", "Ada", "--maintainer-email",
        "ada@example.org", "--destination-directory", "src", cwd=tmp_path,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    manifest = (tmp_path / "src/my_pkg/package.xml").read_text()
    for part in (
        'email="ada@example.org">Ada',
        "<license>MIT",
        "Talks",
        "<depend>std_msgs",
        "ament_cmake</build_type>",
    ):
        assert part in manifest
