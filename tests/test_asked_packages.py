"""DEP103, DEP116: what is used only where the code found out before that the package is there."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = """\
from contextlib import suppress

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    actions = []
{}
    return LaunchDescription(actions)
"""
ADDS = "actions.append(Node(package='mavros', executable='mavros_node'))"
TRIES = """\
    try:
        get_package_share_directory('{}')
        has = True
    except PackageNotFoundError:
        has = False
    if has:
        {}"""
FLAG = """\
    share = None
    try:
        share = get_package_share_directory('{}')
    except Exception:
        pass
    if share:
        {}"""
SUPPRESSES = """\
    with suppress({}):
        get_package_share_directory('mavros')
        {}"""
NODE = """\
from ament_index_python import get_package_share_directory, get_packages_with_prefixes, has_resource


def main():
    if {}:
        print(get_package_share_directory('nav2_bringup'))
"""


def levels(code: str, files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f"    {ADDS}", ["warning"]),
        (TRIES.format("mavros", ADDS), []),
        (TRIES.format("nav2_bringup", ADDS), ["warning"]),
        (FLAG.format("mavros", ADDS), []),
        (FLAG.format("nav2_bringup", ADDS), ["warning"]),
        (SUPPRESSES.format("PackageNotFoundError", ADDS), []),
        (SUPPRESSES.format("OSError", ADDS), ["warning"]),
    ],
)
def test_launch_files(body: str, expected: list[str]) -> None:
    needs = manifest("  <exec_depend>ros2launch</exec_depend>\n")
    assert levels("DEP103", {"package.xml": needs, "launch/a.launch.py": LAUNCH.format(body)}) == expected


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("'nav2_bringup' in get_packages_with_prefixes()", []),
        ("has_resource('packages', 'nav2_bringup')", []),
        ("'nav2_common' in get_packages_with_prefixes()", ["warning"]),
        ("get_packages_with_prefixes()", ["warning"]),
    ],
)
def test_look_ups(condition: str, expected: list[str]) -> None:
    files = {"package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n"), "my_pkg/__init__.py": ""}
    files |= {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/talker.py": NODE.format(condition)}
    assert levels("DEP116", files) == expected
