"""Launch configurations: who sets them, and who asks for them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = """\
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction, SetLaunchConfiguration,
    TimerAction)
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
use = LogInfo(msg=LaunchConfiguration('rate'))
declare = DeclareLaunchArgument('rate', default_value='10')
"""
USE, DECLARE = '<log message="$(var rate)"/>', '<arg name="rate" default="10"/>'
OTHERS = {"package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n")}


def said(files: dict[str, str], *codes: str) -> list[str]:
    """Return the codes of what is said of launch arguments, in the order of the text."""
    results = lint_files({**OTHERS, **files}, codes or ("LCH008", "LCH016"))
    return [finding.code for finding in results.findings]


def xml(body: str) -> dict[str, str]:
    return {"launch/a.launch.xml": f"<launch>\n{body}\n</launch>\n"}


def python(body: str) -> dict[str, str]:
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    return {"launch/a.launch.py": f"{HEAD}\n\ndef generate_launch_description():\n{lines}"}


@pytest.mark.parametrize(
    "body, codes",
    [
        (USE, ["LCH008"]),
        (USE + USE, ["LCH008"]),
        (DECLARE + USE, []),
        (USE + DECLARE, ["LCH016"]),
        (f'{USE}<arg name="rate"/>', []),
        (f'{USE}<arg name="rate"/>{DECLARE}', ["LCH016"]),
        (f'{USE}<arg name="rate"/><let name="rate" value="1"/>', ["LCH016"]),
        ('<let name="rate" value="1"/>' + USE, []),
        ('<log message="$(var rate 10)"/>', []),
        ('<group if="$(var rate)"/>', ["LCH008"]),
        (f"<group>{DECLARE}</group>{USE}", []),
        (f'<group scoped="false">{DECLARE}</group>{USE}', []),
        (f'<include file="$(dirname)/other.launch.xml"/>{USE}', []),
        (f'<group><include file="$(dirname)/other.launch.xml"/></group>{USE}', ["LCH008"]),
        ('<include file="$(dirname)/b.launch.xml"><arg name="rate" value="$(var rate)"/></include>', ["LCH008"]),
        ('<include file="$(dirname)/b.launch.xml"><arg name="rate" value="1"/><arg name="b" value="$(var rate)"/>'
         "</include>", []),
        (f'<timer period="1.0">{USE}</timer>{DECLARE}', []),
        (f"<my_own_action/>{USE}", []),
        (f'<log message="$(my-own x)"/>{USE}', ["LCH008"]),
    ],
)  # fmt: skip
def test_the_order_of_an_xml_file(body: str, codes: list[str]) -> None:
    assert said(xml(body)) == codes


@pytest.mark.parametrize(
    "body, codes",
    [
        ("return LaunchDescription([use])", ["LCH008"]),
        ("return LaunchDescription([declare, use])", []),
        ("return LaunchDescription([use, declare])", ["LCH016"]),
        ("return LaunchDescription([use, DeclareLaunchArgument('rate')])", []),
        ("return LaunchDescription([use, DeclareLaunchArgument('rate', default_value=None)])", []),
        ("ld = LaunchDescription()\nld.add_action(declare)\nld.add_action(use)\nreturn ld", []),
        ("ld = LaunchDescription()\nld.add_action(use)\nld.add_action(declare)\nreturn ld", ["LCH016"]),
        ("ld = LaunchDescription()\nDeclareLaunchArgument('rate')\nld.add_action(use)\nreturn ld", ["LCH008"]),
        ("return LaunchDescription([SetLaunchConfiguration('rate', '1'), use])", []),
        ("return LaunchDescription([GroupAction([declare]), use])", []),
        ("return LaunchDescription([GroupAction([declare, use])])", []),
        ("return LaunchDescription([TimerAction(period=1.0, actions=[use]), declare])", []),
        ("return LaunchDescription([IncludeLaunchDescription('b.launch.py'), use])", []),
        ("return LaunchDescription([IncludeLaunchDescription('b.launch.py',\n"
         "    launch_arguments={'rate': LaunchConfiguration('rate')}.items())])", ["LCH008"]),
        ("return LaunchDescription([GroupAction([use], launch_configurations={'rate': '1'})])", []),
        ("return LaunchDescription([GroupAction([use],\n"
         "    launch_configurations={'rate': LaunchConfiguration('rate')})])", ["LCH008"]),
        ("return LaunchDescription([GroupAction([use], launch_configurations={'rate': '1'}), use])", ["LCH008"]),
        ("names = [DeclareLaunchArgument(n, default_value='') for n in ['rate', 'mode']]\n"
         "return LaunchDescription([*names, use])", []),
        ("return LaunchDescription([OpaqueFunction(function=lambda context: [use])])", ["LCH008"]),
        ("def late(context):\n    context.launch_configurations['rate'] = '1'\n"
         "return LaunchDescription([OpaqueFunction(function=late), use])", []),
        ("def late(context):\n    return [LogInfo(msg=LaunchConfiguration('rate').perform(context))]\n"
         "return LaunchDescription([OpaqueFunction(function=late), declare])", ["LCH016"]),
        ("def late(context):\n    rate = LaunchConfiguration('rate')\n    return [declare, LogInfo(msg=rate)]\n"
         "return LaunchDescription([OpaqueFunction(function=late)])", []),
        ("import other\nreturn LaunchDescription([other.declare(), use])", []),
        ("import other\nreturn other.describe([use])", []),
    ],
)  # fmt: skip
def test_the_order_of_a_python_file(body: str, codes: list[str]) -> None:
    assert said(python(body)) == codes


def test_what_a_file_that_is_not_here_may_set() -> None:
    """The name may be passed on here, and declared in vain, but another file must not have it."""
    include = (
        '<include file="$(find-pkg-share other)/launch/b.launch.xml"><arg name="rate" value="$(var rate)"/></include>'
    )
    files = xml(f'<arg name="mode" default=""/><include file="$(dirname)/c.launch.xml"/>{include}')
    assert said(files) == ["LCH008"]
    assert said({**files, "launch/d.launch.xml": f"<launch>{DECLARE}</launch>"}) == []
    absent = "IncludeLaunchDescription('b.launch.py')"
    assert said(python(f"return LaunchDescription([DeclareLaunchArgument('mode'), {absent}, use])")) == ["LCH008"]


def test_a_file_that_others_include_has_what_these_set() -> None:
    inner = xml(USE)
    passing = '<include file="$(dirname)/a.launch.xml"><arg name="rate" value="1"/></include>'
    silent = '<include file="$(dirname)/a.launch.xml"/>'
    assert said({**inner, "launch/b.launch.xml": f"<launch>{passing}</launch>"}) == []
    assert said({**inner, "launch/b.launch.xml": f"<launch>{DECLARE}{silent}</launch>"}) == []
    assert said({**inner, "launch/b.launch.xml": f"<launch>{silent}</launch>"}) == ["LCH008"]
    inherits = f'<launch><log message="$(var from_elsewhere)"/>{silent}</launch>'
    assert said({**inner, "launch/b.launch.xml": inherits}) == ["LCH008"], "of b alone: what starts b sets more"
    outer = {"launch/b.launch.xml": f"<launch>{silent}</launch>"}
    outer["launch/c.launch.xml"] = f'<launch>{DECLARE}<include file="$(dirname)/b.launch.xml"/></launch>'
    assert said({**inner, **outer}) == []


def test_a_file_that_asks_for_much_and_passes_it_on_is_made_to_be_included() -> None:
    names = ["a", "b", "c", "d"]
    passed = "".join(f'<arg name="{name}" value="$(var {name})"/>' for name in names)
    include = f'<include file="$(find-pkg-share other)/launch/b.launch.xml">{passed}</include>'
    assert said(xml(include)) == []
    assert said(xml('<log message="$(var e)"/>' + include)) == ["LCH008"]


def test_the_name_of_an_included_file_is_told_by_its_last_pieces() -> None:
    path = "PathJoinSubstitution([FindPackageShare('my_pkg'), 'launch', 'b.launch.xml'])"
    files = python(f"return LaunchDescription([IncludeLaunchDescription({path}), use])")
    files["launch/a.launch.py"] = (
        "from launch.substitutions import PathJoinSubstitution\n"
        "from launch_ros.substitutions import FindPackageShare\n" + files["launch/a.launch.py"]
    )
    assert said({**files, "launch/b.launch.xml": f"<launch>{DECLARE}</launch>"}) == []
    assert said({**files, "launch/b.launch.xml": "<launch/>"}) == ["LCH008"]
    assert said(files) == []


def test_a_file_that_is_included_sets_what_it_declares() -> None:
    includes = '<include file="$(dirname)/b.launch.xml"/>'
    assert said({**xml(includes + USE), "launch/b.launch.xml": f"<launch>{DECLARE}</launch>"}) == []
    assert said({**xml(includes + USE), "launch/b.launch.xml": "<launch/>"}) == ["LCH008"]


@pytest.mark.parametrize(
    "files, count",
    [
        (xml(DECLARE), 1),
        (xml(DECLARE + USE), 0),
        (xml(DECLARE + '<include file="b.launch.xml"/>'), 0),
        (python("return LaunchDescription([declare])"), 0),
        (python("d = DeclareLaunchArgument('mode')\nreturn LaunchDescription([d])"), 1),
        (python("d = DeclareLaunchArgument('mode')\nprint('mode')\nreturn LaunchDescription([d])"), 0),
    ],
)
def test_arguments_that_nothing_asks_for(files: dict[str, str], count: int) -> None:
    results = lint_files({**OTHERS, **files}, ["LCH017"])
    assert len(results.findings) == count


@pytest.mark.parametrize(
    "expression, levels",
    [
        ("['not ', rate]", []),
        ("['not ', flag]", ["warning"]),
        ("[\"'\", flag, \"' == 'true'\"]", []),
        ("['not (', rate]", ["error"]),
        ("[rate, ' and and ', flag]", ["error"]),
        ("[rate, ' == unknown']", ["error"]),
        ("['os.getpid() > ', rate], ['os']", []),
        ("['sqrt(', rate, ') > 2']", []),
        ("[unknown()]", []),
        ("['not (', unknown()]", []),
    ],
)
def test_python_expressions(expression: str, levels: list[str]) -> None:
    files = python(
        "rate, flag = LaunchConfiguration('rate'), LaunchConfiguration('flag')\n"
        "return LaunchDescription([declare, DeclareLaunchArgument('flag', default_value='true'),\n"
        f"    LogInfo(msg='x', condition=IfCondition(PythonExpression({expression})))])"
    )
    results = lint_files({**OTHERS, **files}, ["LCH007"])
    assert [finding.severity.value for finding in results.findings] == levels


def test_a_parameter_that_is_the_name_of_an_argument() -> None:
    node = '<node pkg="p" exec="e"><param name="rate" value="rate"/></node>'
    assert said(xml(DECLARE + node), "LCH007") == ["LCH007"]
    assert said(xml(DECLARE + USE + node), "LCH007") == []
    assert said(xml(node), "LCH007") == []


OFF = ", but only if its condition holds (not by default)"


@pytest.mark.parametrize(
    ("body", "level"),
    [
        ('<arg name="gui" default="false"/><group if="$(var gui)"><log message="$(var rate)"/></group>', "info"),
        ('<arg name="gui" default="true"/><group if="$(var gui)"><log message="$(var rate)"/></group>', "warning"),
        ('<arg name="gui"/><group if="$(var gui)"><log message="$(var rate)"/></group>', "warning"),
        (f'<arg name="gui" default="false"/><group if="$(var gui)">{USE}</group>{USE}', "warning"),
        ('<arg name="gui" default="false"/><log if="$(var gui)" message="$(var rate)"/>', "info"),
        ('<arg name="gui" default="false"/><log if="$(var rate)" message="$(var gui)"/>', "warning"),
    ],
)
def test_what_is_only_asked_for_under_a_condition_that_is_off_is_an_info(body: str, level: str) -> None:
    (found,) = lint_files({**OTHERS, **xml(body)}, ["LCH008"]).findings
    assert found.severity.value == level
    assert (OFF in found.message) == (level == "info")


def test_an_action_of_python_that_is_off_asks_for_nothing() -> None:
    body = """\
gui = DeclareLaunchArgument('gui', default_value='{}')
use = LogInfo(msg=LaunchConfiguration('rate'), condition=IfCondition(LaunchConfiguration('gui')))
return LaunchDescription([gui, use])"""
    for default, level in (("false", "info"), ("true", "warning")):
        (found,) = lint_files({**OTHERS, **python(body.format(default))}, ["LCH008"]).findings
        assert found.severity.value == level


def test_a_declaration_behind_a_use_that_is_off_is_an_info() -> None:
    off = '<arg name="gui" default="{}"/><log if="$(var gui)" message="$(var rate)"/>' + DECLARE
    for default, level in (("false", "info"), ("true", "warning")):
        (found,) = lint_files({**OTHERS, **xml(off.format(default))}, ["LCH016"]).findings
        assert found.severity.value == level
