"""Values that nodes get otherwise than by the parameters of their launch action."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode

SETS = regex(
    r"""(?:\bSetParameter\s*\(|<set_parameter\b|\bset_parameter\s*:)\s*(?:-?\s*name\s*[=:]\s*)?(?:["']?(\w+)(?:["']|\s*\n))?"""
    r"""|\bSetParametersFromFile\s*\(|\bset_parameters_from_file\b"""
)
"""Actions and entities that give parameters to every node behind them, with the name where it is written."""


def may_be_set(node: LaunchedNode, names: Collection[str], launches: Iterable[LaunchFile]) -> bool:
    """Return whether the command line of a node may give it one of some parameters, or a launch file to all nodes."""
    words = [argument.literal for argument in node.arguments]
    if None in words or any(part in (word or "") for word in words for part in (":=", "-p", "param")):
        return True
    found = (each[1] for launch in launches for each in SETS.finditer(launch.source.text))
    return any(name is None or name in names for name in found)
