"""Helpers of launch files that take plain values as well as substitutions: LCH014 leaves their comparisons alone."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration


def text_of(context, param):
{body}

def setup(context, *args, **kwargs):
    sim = LaunchConfiguration('sim')
    return [LogInfo(msg=text_of(context, {given}))]


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('sim', default_value='false'), OpaqueFunction(function=setup)])
"""
WHOLE = ("return 'off' if param == False or param.perform(context) == 'false' else 'on'",)
CHAIN = ("return 'false' if param == False else 'true' if param == True else param.perform(context)",)
BRANCHES = (
    "if param == True:",
    "    return 'true'",
    "elif param == False:",
    "    return 'false'",
    "return param.perform(context)",
)
ELSE = ("if param != 'auto':", "    found = param.perform(context)", "else:", "    found = 'auto'", "return found")
ASKED = ("if isinstance(param, bool):", "    return str(param)", "return 'a' if param == 'a' else 'b'")
BY_CONTEXT = ("return 'x' if param == True else context.perform_substitution(param)",)
BARE = ("return 'off' if param == False else 'on'",)
BOTH = ("found = 'off'", "if param == True:", "    found = 'on'", "return found + param.perform(context)")
WITHIN = ("return param.perform(context) if param == 'a' else 'b'",)


def compared(body: tuple[str, ...], given: str = "sim") -> int:
    text = HEAD.format(body="".join(f"    {line}\n" for line in body), given=given)
    files = {"src/my_pkg/package.xml": manifest(), "src/my_pkg/launch/a.launch.py": text}
    return len([each for each in lint_files(files, ["LCH014"]).findings if "true, since" in each.message])


@pytest.mark.parametrize("body", [WHOLE, CHAIN, BRANCHES, ELSE, ASKED, BY_CONTEXT])
def test_a_helper_that_performs_what_is_no_plain_value(body: tuple[str, ...]) -> None:
    assert compared(body) == 0


@pytest.mark.parametrize("body", [BARE, BOTH, WITHIN])
def test_a_helper_that_takes_substitutions_for_plain_values(body: tuple[str, ...]) -> None:
    assert compared(body) == 1


@pytest.mark.parametrize(
    "expression, found",
    [
        ("'a' if sim == 'true' or sim.perform(context) == 'true' else 'b'", 0),
        ("'a' if sim != 'true' and sim.perform(context) != 'true' else 'b'", 0),
        ("'a' if sim == 'true' and sim.perform(context) == 'true' else 'b'", 1),
        ("'a' if sim == 'true' else sim.perform(context)", 1),
        ("'a' if sim == 'true' or LaunchConfiguration('b').perform(context) == 'true' else 'b'", 1),
    ],
)
def test_what_a_file_makes_itself_is_no_plain_value(expression: str, found: int) -> None:
    assert compared(("return param",), expression) == found
