"""Fixes of package.xml that leave no choice: tags of other formats, versions of two numbers."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])


def found(code: str, text: str) -> list[Finding]:
    return list(lint_files({**PYTHON, "package.xml": text}, [code]).findings)


def written(finding: Finding) -> str | None:
    return finding.fix.operations[0].text if finding.fix is not None else None


@pytest.mark.parametrize(
    "line, text, safety",
    [
        ("<run_depend>rclpy</run_depend>", "<exec_depend>rclpy</exec_depend>", "safe"),
        ("<exec_dependency>rclpy</exec_dependency>", "<exec_depend>rclpy</exec_depend>", "unsafe"),
        (
            '<exec_dependency condition="$ROS_VERSION == 2">rclpy</exec_dependency>',
            '<exec_depend condition="$ROS_VERSION == 2">rclpy</exec_depend>',
            "unsafe",
        ),
        ("<exec_depends>rclpy</exec_depends>", "<exec_depend>rclpy</exec_depend>", "unsafe"),
        ("<architecture_independent/>", None, ""),
        ("<nothing_alike>x</nothing_alike>", None, ""),
    ],
)
def test_tags_that_are_meant(line: str, text: str | None, safety: str) -> None:
    (finding,) = found("XML001", manifest(f"  {line}\n"))
    assert written(finding) == text
    assert (finding.fix.safety.value if finding.fix else "") == safety


def test_a_tag_of_format_2_is_right_in_it() -> None:
    (finding,) = found("XML001", manifest("  <exec_depend>rclpy</exec_depend>\n").replace('"3"', '"1"'))
    assert finding.fix is None
    (finding,) = found("XML001", manifest("  <depend>rclpy<run_depend>x</run_depend></depend>\n"))
    assert finding.fix is None


@pytest.mark.parametrize(
    "version, whole",
    [("1.0", "1.0.0"), ("2", "2.0.0"), ("0.3", "0.3.0"), ("1.2.3-rc1", None), ("1.2.3.4", None), ("01.2", None),
     ("v1.0", None), ("1.", None), ("1.02.0", None)],
)  # fmt: skip
def test_versions_that_lack_numbers(version: str, whole: str | None) -> None:
    (finding,) = found("XML103", manifest().replace("1.0.0", version))
    assert written(finding) == whole


def test_a_version_in_cdata_is_left_alone() -> None:
    (finding,) = found("XML103", manifest().replace("1.0.0", "<![CDATA[1.0]]>"))
    assert finding.fix is None or "CDATA" not in finding.fix.operations[0].text


def test_a_package_that_setup_py_calls_otherwise_is_told_once() -> None:
    setup = PYTHON["setup.py"].replace("package_name = 'my_pkg'", "package_name = 'my_robot'")
    launch = "<launch>\n  <node pkg='rviz2' exec='rviz2' args='-d $(find-pkg-share my_pkg)/rviz/a.rviz'/>\n</launch>\n"
    files = {**PYTHON, "setup.py": setup, "launch/a.launch.xml": launch, "rviz/a.rviz": "Panels: []\n"}
    assert [f.code for f in lint_files(files, ["SET401", "LCH004"]).findings] == ["SET401"]
    files["setup.py"] = PYTHON["setup.py"].replace(
        "os.path.join('share', package_name", "os.path.join('share', 'my_robot'"
    )
    assert {f.code for f in lint_files(files, ["SET208", "SET401", "LCH004"]).findings} == {"SET208"}
