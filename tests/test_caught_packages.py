"""A function of a launch file that catches the lack of a package does so for all that call it (DEP103)."""

from __future__ import annotations

import pytest
from test_off_by_default import HEAD, told

HELPER = """

def share(name, other=None):
    try:
        return get_package_share_directory(name)
    except {}:
        return other


def generate_launch_description():
    {}
    return LaunchDescription([])
"""
HEAD = HEAD.replace("JOY = Node(package='joy', executable='joy_node')\n", "")


@pytest.mark.parametrize(
    ("caught", "line"),
    [
        ("FileNotFoundError", "print(share('joy'))"),
        ("PackageNotFoundError", "print(share('joy'), get_package_share_directory('joy'))"),
    ],
)
def test_what_stops(caught: str, line: str) -> None:
    assert told(HEAD + HELPER.format(caught, line), "launch/a.launch.py")[0] == "warning"


@pytest.mark.parametrize("caught", ["PackageNotFoundError", "Exception"])
def test_what_is_caught(caught: str) -> None:
    with pytest.raises(ValueError, match="not enough values"):
        told(HEAD + HELPER.format(caught, "print(share('joy'))"), "launch/a.launch.py")
