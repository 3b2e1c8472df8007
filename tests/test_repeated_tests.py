"""Tests that Python always passes, before actions that have conditions of their own (LCH014)."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.call_errors import call_faults
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.package.package import Package
from rospkg_cli.tree import MemoryTree

TEXT = """\
from launch import LaunchDescription
from launch.conditions import IfCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    rviz = LaunchConfiguration('rviz')
    sim = LaunchConfiguration('sim')
    viewer = None
    viewer = Node(package='rviz2', executable='rviz2'{})
    plain = Node(package='rviz2', executable='rviz2')
    ld = LaunchDescription()
    if {}:
        {}
    return ld
"""
SHOWN = ", condition=IfCondition(rviz)"
ADD = "ld.add_action(viewer)"


def level(condition: str, test: str, body: str = ADD) -> str | None:
    text = TEXT.format(condition, test, body)
    file = Package(PackageFiles(MemoryTree.of({"launch/a.launch.py": text}), "")).parts(LaunchFile).only
    assert file is not None
    (found,) = call_faults(file)
    assert ("says the same" in found.message) is (found.level == "info")
    return found.level


@pytest.mark.parametrize(
    "condition, test",
    [
        (SHOWN, "LaunchConfigurationEquals('rviz', 'True')"),
        (SHOWN, "LaunchConfigurationEquals('rviz', 'True') and viewer is not None"),
        (SHOWN, "LaunchConfigurationNotEquals('rviz', 'false')"),
        (SHOWN, "IfCondition(rviz) and LaunchConfiguration('rviz')"),
        (SHOWN, "rviz"),
        (", condition=UnlessCondition(rviz)", "LaunchConfigurationEquals('rviz', 'False')"),
        (", condition=LaunchConfigurationEquals('rviz', 'all')", "LaunchConfigurationEquals('rviz', 'all')"),
    ],
)
def test_a_condition_that_says_the_same_makes_up_for_it(condition: str, test: str) -> None:
    assert level(condition, test) == "info"


@pytest.mark.parametrize(
    "condition, test",
    [
        ("", "IfCondition(rviz)"),
        (SHOWN, "IfCondition(sim)"),
        (SHOWN, "IfCondition(rviz) and IfCondition(sim)"),
        (SHOWN, "UnlessCondition(rviz)"),
        (SHOWN, "LaunchConfigurationEquals('rviz', 'all')"),
        (", condition=LaunchConfigurationEquals('rviz', 'all')", "IfCondition(rviz)"),
        (", condition=IfCondition([rviz, sim])", "IfCondition(rviz)"),
    ],
)
def test_one_that_says_something_else_does_not(condition: str, test: str) -> None:
    assert level(condition, test) == "warning"


@pytest.mark.parametrize(
    "body, expected",
    [
        (f"{ADD}; ld.add_action(Node(package='a', executable='b'{SHOWN}))", "info"),
        ("[].append(viewer)", "info"),
        (f"{ADD}; ld.add_action(plain)", "warning"),
        (f"{ADD}; print('rviz')", "warning"),
        (f"{ADD}; rate = 1", "warning"),
        ("ld.add_action(ld)", "warning"),
        (f"{ADD}\n    else:\n        ld.add_action(plain)", "warning"),
        (f"{ADD}\n    for viewer in ():\n        pass", "warning"),
    ],
)
def test_what_else_is_done_under_it_differs(body: str, expected: str) -> None:
    assert level(SHOWN, "IfCondition(rviz)", body) == expected
