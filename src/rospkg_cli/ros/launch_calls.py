"""What the classes of launch and launch_ros take, for Python launch files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal, cast

from ..light_dataclasses import dataclass
from .read_table import rows, unfolded, words

Kind = Literal[
    "any", "text", "words", "paths", "condition", "actions", "parameters", "remappings", "pairs", "output", "period"
]
"""What an argument takes; "text" is a str, a substitution or a list of these, "words" and "paths" a list of such."""

TABLE = "launch_calls.txt"


@dataclass(frozen=True)
class Signature:
    positional: tuple[str, ...]
    """Arguments that may be passed by place; None may follow for any number."""
    kinds: Mapping[str, Kind]
    required: frozenset[str]
    optional: frozenset[str]
    """Arguments that may be None."""


def signature(row: Iterable[str]) -> Signature:
    """Read `name:kind! name …`: `!` is required, `?` may be None, `!?` is both; behind a lone `*` are keywords."""
    kinds: dict[str, Kind] = {}
    required, optional, positional, by_place = set(), set(), [], True
    for word in row:
        if word == "*":
            by_place = False
            continue
        name, _, kind = word.rstrip("!?").partition(":")
        kinds[name] = cast("Kind", kind or "any")
        required |= {name} if word.rstrip("?").endswith("!") else set()
        optional |= {name} if word.endswith("?") else set()
        positional += [name] if by_place else []
    return Signature(tuple(positional), kinds, frozenset(required), frozenset(optional))


SIGNATURES: Mapping[str, Signature] = {
    name: signature(unfolded(row, rows(TABLE, "parts"))) for name, row in rows(TABLE, "calls").items()
}
ACTIONS = words(TABLE, "actions")
CONDITIONS = words(TABLE, "conditions")
SUBSTITUTIONS = words(TABLE, "substitutions")
OUTPUTS = words(TABLE, "outputs")
DESCRIPTION_LOADERS = frozenset(
    f"get_launch_description_from_{kind}_launch_file" for kind in ("python", "frontend", "any")
)
"""Functions that return the description of another launch file. (launch/launch_description_sources)"""
