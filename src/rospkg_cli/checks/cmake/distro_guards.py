"""Commands inside an `if` that depends on the distribution, or on a command that only some have."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.syntax import CommandInvocation
from ...lazy_regex import regex

DISTRO_TEST = regex(r"ROS_DISTRO|ament_target_dependencies|\b(?:rclcpp|ament_cmake\w*)_VERSION\b")
"""What a condition contains that tests for it."""


def guarded_commands(
    body: Iterable[CommandInvocation | Block], test: re.Pattern[str] = DISTRO_TEST
) -> Iterator[CommandInvocation]:
    """Yield, in no order, the commands inside an `if` that makes a test, by default for the distribution."""
    waiting = [(each, False) for each in body]
    while waiting:
        each, inside = waiting.pop()
        if isinstance(each, CommandInvocation):
            if inside:
                yield each
        else:
            conditions = (argument.text for branch in each.branches for argument in branch.command.arguments)
            is_guard = each.command.name == "if" and any(test.search(text) for text in conditions)
            waiting += [(below, inside or is_guard) for branch in each.branches for below in branch.body]
