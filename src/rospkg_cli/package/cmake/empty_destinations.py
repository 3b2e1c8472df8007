"""`DESTINATION` of install rules with nothing behind it: CMake installs to its defaults, without a message."""

from __future__ import annotations

from itertools import pairwise

from ...languages.cmake.syntax import CommandArgument
from .install_keywords import ARTIFACTS, OPTIONS
from .install_rule import InstallRule

KEYWORD = "DESTINATION"
OTHERS = frozenset({*OPTIONS, *ARTIFACTS})


def empty_destination(rule: InstallRule) -> CommandArgument | None:
    """Return the keyword that lacks its value, where the call itself has it; None where there is none."""
    arguments = [each for each in rule.call.command.arguments if each.kind != "bracket"]
    for each, after in pairwise([*arguments, None]):
        if each is not None and each.text == KEYWORD and (after is None or after.text in OTHERS):
            return each
    return None
