"""Whichever rule tells of it: what no plain launch comes to in a launch file is an info, with the reason."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

IMPORTS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


"""
CHOICE = """\
def generate_launch_description():
    sim = LaunchConfiguration('sim')
    extra = []
    if sim:
        config = 'a.yaml'{more}
    elif {other}:
        config = 'b.yaml'
    else:
        pass
    node = Node(package='my_pkg', executable='talker', parameters=[config])
    {then}
    return LaunchDescription([DeclareLaunchArgument('sim', default_value='true'){added}])
"""
ARM = """\
<launch>
  <arg name="speed"/>
  <let name="twice" value="$(var speed)"/>
</launch>
"""
INCLUDE = """\
def generate_launch_description():
    rest = IncludeLaunchDescription(
        AnyLaunchDescriptionSource([FindPackageShare('my_pkg'), '/launch/arm.launch.xml']),
    )
    return LaunchDescription([])
"""
HELPER = """\
def {name}({argument}):
    return [missing]


def generate_launch_description():
    return LaunchDescription({made})
"""


def found(text: str, code: str, path: str = "launch/a.launch.py", **files: str) -> list[tuple[str, str]]:
    written = {
        "package.xml": manifest(),
        "setup.py": SETUP_PY_FOR_ALL,
        "my_pkg/__init__.py": "",
        "launch/arm.launch.xml": ARM,
    }
    written |= {f"launch/{name}.py": each for name, each in files.items()}
    findings = lint_files({**written, path: IMPORTS + text}, [code]).findings
    return [(each.severity.value, each.message) for each in findings]


@pytest.mark.parametrize(
    ("added", "more", "other", "then", "level"),
    [
        ("", "", "True", "pass", "info"),
        (", node", "", "True", "pass", "warning"),
        ("", "", "True", "extra.append(node)", "info"),
        (", *extra", "", "True", "extra.append(node)", "warning"),
        ("", "", "True", "extra = other = [node]\n    check(other)", "warning"),
        ("", "\n        print('simulated')", "True", "pass", "warning"),
        ("", "\n        return LaunchDescription([])", "True", "pass", "warning"),
        ("", "", "(extra := [1])", "pass", "warning"),
    ],
)
def test_a_choice_among_values_that_nothing_reads(added: str, more: str, other: str, then: str, level: str) -> None:
    ((told, message),) = found(CHOICE.format(added=added, more=more, other=other, then=then), "LCH014")
    assert told == level, message
    assert ("but nothing uses the value; test it" in message) is (level == "info")


@pytest.mark.parametrize(("made", "level"), [("[]", "info"), ("[rest]", "warning")])
def test_an_include_that_nothing_adds(made: str, level: str) -> None:
    told = found(
        INCLUDE.replace("([])", f"({made})"),
        "LCH015",
    )
    assert [each for each, _ in told] == [level]


@pytest.mark.parametrize(
    ("argument", "made", "level"),
    [("", "[]", "info"), ("", "helper()", "error"), ("path=unknown", "helper()", "error"), ("", "others()", "info")],
)
def test_a_function_that_nothing_calls(argument: str, made: str, level: str) -> None:
    text = HELPER.format(name="helper", argument=argument, made=made)
    assert level in {each for each, message in found(text, "LCH013") if "`missing`" in message}


def test_what_python_runs_of_a_function_that_nothing_calls() -> None:
    told = found(HELPER.format(name="helper", argument="path=unknown", made="[]"), "LCH013")
    assert {(level, message.split("`")[1]) for level, message in told} == {("error", "unknown"), ("info", "missing")}


METHOD = "class Loader:\n    def load(self):\n        return by_method()\n\n\n"


@pytest.mark.parametrize(("other", "level"), [("", "info"), ("from parts import Loader\n", "error")])
def test_a_method_that_nothing_calls(other: str, level: str) -> None:
    text = METHOD + HELPER.format(name="by_method", argument="", made="[]")
    ((told, message),) = found(text, "LCH013", "launch/parts.py", others=other)
    assert told == level
    assert message.endswith("; nothing calls the function") is (level == "info")


def test_a_number_at_which_python_stops_though_nothing_adds_the_action() -> None:
    text = "def generate_launch_description():\n    node = Node(package='a', executable='b', arguments=[1.5])\n"
    told = found(f"{text}    return LaunchDescription([])\n", "LCH014")
    assert [level for level, _ in told] == ["error"]
