"""Commands that run only where the distribution, or a command of it, is the right one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from .blocks import Block
from .syntax import Command

ASKS = re.compile(r"ROS_DISTRO|ament_target_dependencies|\b(?:rclcpp|ament_cmake\w*)_VERSION\b")
"""What a condition says that asks for it."""


def guarded(body: Iterable[Command | Block], inside: bool = False) -> Iterator[Command]:
    """Yield the commands that stand in an `if` that asks for the distribution, or whether a command is there."""
    for each in body:
        if isinstance(each, Command):
            if inside:
                yield each
        else:
            asked = (argument.text for branch in each.branches for argument in branch.command.arguments)
            asks = each.command.name == "if" and any(ASKS.search(text) for text in asked)
            for branch in each.branches:
                yield from guarded(branch.body, inside or asks)
