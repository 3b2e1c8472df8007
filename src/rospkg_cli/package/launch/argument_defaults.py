"""The default values of a launch file's arguments."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from .launched_parts import DeclaredArgument
from .text import LaunchText


def literal_defaults(arguments: Iterable[DeclaredArgument], assigned: Iterable[LaunchText]) -> Mapping[str, str]:
    """Return the literal defaults of the arguments that are declared once and that the file does not set itself."""
    found: dict[str, list[str | None]] = {name: [] for text in assigned if (name := text.literal)}
    for argument in arguments:
        if name := argument.name.literal:
            found.setdefault(name, [None]).append(argument.default.literal if argument.default else None)
    return {name: given[1] for name, given in found.items() if len(given) == 2 and given[0] is None and given[1]}
