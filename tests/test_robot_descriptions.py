"""Robots that launch files read as YAML: what counts as theirs, how often it is told, and how the fix is written."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.finding import Finding
from rospkg_cli.rules.launch import lch009_unquoted_robot_description as lch009
from rospkg_cli.testing import lint_files

LAUNCH = lch009.BAD.replace("«", "").replace("»", "")
ROBOT = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n{}\n</robot>\n'
MACRO = '<xacro:macro name="m" params="p">\n  <link name="a"/>\n</xacro:macro>'


def lint(launch: str = LAUNCH, robot: str = "", **more: str) -> tuple[Finding, ...]:
    files = {"package.xml": manifest(lch009.NEEDED), "urdf/robot.urdf.xacro": ROBOT.format(robot)}
    files["launch/a.launch.py"] = launch
    files |= {name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}
    return lint_files(files, ["LCH009"]).findings


@pytest.mark.parametrize(
    "robot, level",
    [
        (f"<!-- base: x -->\n{MACRO}", "info"),
        (f"<!-- base: x --> <!-- b -->\n{MACRO}", "info"),
        (f"<!-- base: x -->\n<!-- b -->\n  {MACRO}", "info"),
        (f"<!-- base: x -->\n\n{MACRO}", "warning"),
        (f"<!-- base: x -->\n<link name='a'/>\n{MACRO}", "warning"),
        (f"<!-- base: x -->\n<!-- b -->\n<link name='a'/>\n{MACRO}", "warning"),
        (f"{MACRO}\n<!-- base: x -->", "warning"),
        ('<xacro:property name="a" value="b: c"/>', "info"),
        ('<plugin name="b: c"/>', "warning"),
        ('<plugin name="b: c"/><xacro:arm/>', "warning"),
    ],
)
def test_comments_that_xacro_drops_do_not_count(robot: str, level: str) -> None:
    (finding,) = lint(robot=robot)
    assert finding.severity.value == level


def test_a_plain_urdf_keeps_its_comments() -> None:
    launch = LAUNCH.replace("robot.urdf.xacro", "robot.urdf")
    (finding,) = lint(launch, urdf__robot_DOT_urdf="<robot>\n<!-- base: x -->\n<link name='a'/>\n</robot>\n")
    assert finding.severity.value == "warning"


def test_all_that_works_so_far_is_one_finding_of_a_package() -> None:
    (finding,) = lint(launch__b_DOT_launch_DOT_py=LAUNCH)
    assert [(where.path, text) for where, text in finding.related] == [("launch/b.launch.py", "here too")]
    assert finding.fix is not None
    assert {edit.path for edit in finding.fix.operations} == {"launch/a.launch.py", "launch/b.launch.py"}


def test_what_stops_is_told_at_each_place() -> None:
    found = lint(robot='<p name="b: c"/>', launch__b_DOT_launch_DOT_py=LAUNCH)
    assert [each.location.path for each in found] == ["launch/a.launch.py", "launch/b.launch.py"]


SHORT = "'robot_description': description"
LONG = "'use_sim_time': use_sim_time_of_it, 'robot_description': Command(['xacro ', 'my_robot.urdf.xacro'])"


def fixed(value: str, **more: str) -> list[str]:
    """Return the lines that the fix writes in place of the one with the value."""
    (finding,) = lint(LAUNCH.replace(SHORT, value), **more)
    if finding.fix is None:
        return []
    text = LAUNCH.replace(SHORT, value)
    for edit in sorted(finding.fix.operations, key=lambda each: -each.span.start):  # type: ignore[union-attr]
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]  # type: ignore[union-attr]
    at = text.index("            parameters=[")
    return text[at : text.index("\n        )", at)].split("\n")


def test_a_short_call_stays_in_its_line() -> None:
    assert fixed(SHORT) == [
        "            parameters=[{'robot_description': ParameterValue(description, value_type=str)}],"
    ]


def test_a_long_call_is_broken_over_lines() -> None:
    assert fixed(LONG) == [
        "            parameters=[{'use_sim_time': use_sim_time_of_it, 'robot_description': ParameterValue(",
        "                Command(['xacro ', 'my_robot.urdf.xacro']), value_type=str",
        "            )}],",
    ]


@pytest.mark.parametrize(
    "name, text",
    [
        ("setup_DOT_cfg", "[flake8]\nmax-line-length = 160\n"),
        ("_DOT_flake8", "[flake8]\nmax_line_length=160\n"),
        ("pyproject_DOT_toml", "[tool.ruff]\nline-length = 160\n"),
    ],
)
def test_the_package_says_how_long_a_line_may_be(name: str, text: str) -> None:
    assert len(fixed(LONG, **{name: text})) == 1


def test_a_line_of_the_width_fits() -> None:
    (line,) = fixed(SHORT)
    assert len(fixed(SHORT, setup_DOT_cfg=f"[flake8]\nmax-line-length = {len(line)}\n")) == 1
    assert len(fixed(SHORT, setup_DOT_cfg=f"[flake8]\nmax-line-length = {len(line) - 1}\n")) == 3


def test_no_fix_where_no_break_helps() -> None:
    assert fixed(LONG, setup_DOT_cfg="[flake8]\nmax-line-length = 79\n") == []


def test_a_config_above_the_package_counts() -> None:
    long = LAUNCH.replace(SHORT, LONG)
    files = {"src/my_pkg/package.xml": manifest(lch009.NEEDED), "src/my_pkg/launch/a.launch.py": long}
    (broken,) = lint_files(files, ["LCH009"]).findings
    (whole,) = lint_files({**files, ".flake8": "[flake8]\nmax-line-length = 160\n"}, ["LCH009"]).findings
    assert broken.fix is not None
    assert whole.fix is not None
    assert [len(each.text) for each in broken.fix.operations] > [len(each.text) for each in whole.fix.operations]  # type: ignore[union-attr]


def test_a_node_that_nothing_adds_gets_no_robot() -> None:
    adds = "    return LaunchDescription(["
    idle = LAUNCH.replace(adds, "    node = (").replace("    ])", "    )\n    return LaunchDescription([])")
    assert idle != LAUNCH
    robot = "<!-- base: x -->\n<link name='a'/>"
    assert lint(idle, robot) == ()
    assert len(lint(idle.replace("([])", "([node])"), robot)) == 1
