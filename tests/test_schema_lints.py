"""Whether `colcon test` compares package.xml with its schema: what ament_lint_auto finds, and CMake itself."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

AUTO = "find_package(ament_lint_auto REQUIRED)\nament_lint_auto_find_test_dependencies()\n"
XMLLINT = "find_package(ament_cmake_xmllint REQUIRED)\n"


@pytest.mark.parametrize(
    ("tag", "name", "lines", "level"),
    [
        ("test_depend", "ament_lint_common", AUTO, "warning"),
        ("test_depend", "ament_cmake_xmllint", AUTO, "warning"),
        ("test_depend", "ament_xmllint", AUTO, "info"),
        ("depend", "ament_cmake_xmllint", AUTO, "info"),
        ("build_depend", "ament_lint_common", AUTO, "info"),
        ("depend", "ament_cmake_xmllint", XMLLINT + AUTO, "warning"),
        ("depend", "ament_cmake_xmllint", "# " + XMLLINT + AUTO, "info"),
        ("depend", "ament_cmake_xmllint", "ament_auto_find_build_dependencies()\n" + AUTO, "warning"),
        ("depend", "ament_cmake_xmllint", XMLLINT + "ament_xmllint()\n", "warning"),
        ("test_depend", "ament_lint_common", "", "info"),
        ("test_depend", "ament_lint_auto", AUTO, "info"),
    ],
)
def test_what_runs_ament_xmllint(tag: str, name: str, lines: str, level: str) -> None:
    text = manifest(f"  <{tag}>{name}</{tag}>\n", "ament_cmake").replace(
        "  <license>", "  <url>https://x.org</url>\n  <license>"
    )
    files = {"package.xml": text, "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package")}
    (finding,) = lint_files(files, ["XML002"]).findings
    assert finding.severity.value == level
    assert ("`colcon test` fails" in finding.message) is (level == "warning")
