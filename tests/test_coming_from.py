"""docs/coming-from.md: its options are taken, and what other tools find is found by the rules that it names."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from in_process import run_here

from rospkg_cli.testing import lint_files

TEXT = (Path(__file__).parents[1] / "docs/coming-from.md").read_text(encoding="utf-8")

FAULTS = {
    "unknown or missing elements": ("<license>Apache-2.0</license>", "<licence>Apache-2.0</licence>"),
    "format missing, old": ('format="3"', 'format="2"'),
    "unsupported": ('format="3"', 'format="4"'),
    "name of the package": ("<name>my_pkg</name>", "<name>My-Pkg</name>"),
    "version X.Y.Z": ("<version>1.0.0</version>", "<version>1.0</version>"),
    "email of the maintainer": ("ada@example.org", "ada"),
    "order of elements": (r"(?s)(  <version>.*?\n)(  <description>.*?\n)", r"\2\1"),
    "order of dependencies": (
        "  <export>",
        "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>nav_msgs</exec_depend>\n",
    ),
    "duplicates": ("  <export>", "  <exec_depend>rclpy</exec_depend>\n" * 2),
    "beside build, build_export": ("  <export>", "  <depend>rclpy</depend>\n  <exec_depend>rclpy</exec_depend>\n"),
    "build tool": ("  <export>", "  <buildtool_depend>ament_python</buildtool_depend>\n"),
    "build type": ("<build_type>ament_python</build_type>", "<build_type>ament_pyhton</build_type>"),
    "rosdep keys": ("  <export>", "  <exec_depend>opencv-python</exec_depend>\n"),
    "XML that can't be read": ("</package>", "</pakage>"),
    "the schema of package.xml": ("<license>Apache-2.0</license>", "<licence>Apache-2.0</licence>"),
    "no `<?xml-model?>`": (r"<\?xml-model.*?\?>\n", ""),
}
"""A part of a row's first cell, and what makes such a fault of a faultless package.xml; `<export>` is kept."""


@pytest.mark.parametrize("row", FAULTS)
def test_a_fault_of_another_tool_is_found_by_a_rule_of_its_row(row: str, clean: dict[str, str]) -> None:
    pattern, replacement = FAULTS[row]
    kept = replacement + ("  <export>" if pattern == "  <export>" else "")
    broken = re.sub(pattern, kept, clean["package.xml"], count=1)
    assert broken != clean["package.xml"]
    [line] = [line for line in TEXT.splitlines() if line.startswith("| ") and row in line]
    found = lint_files({**clean, "package.xml": broken}, re.findall(r"\[(\w+\d+)\]", line)).findings
    assert found


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
