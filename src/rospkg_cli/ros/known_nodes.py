"""The nodes of well-known packages by name, and the parameters that these and their plugins declare."""

from __future__ import annotations

from functools import cache

from ..light_dataclasses import dataclass
from .read_table import rows

NAMES = "node_names.txt"
TABLE = "well_known_parameters.txt"
NEWER = "newer_parameters.txt"
CHANGED = "changed_parameters.txt"
OF_TABLES = "known_defaults.txt", "more_defaults.txt"
TYPES = {"b": "bool", "d": "double", "i": "int", "s": "string"}
TAIL = "*"


@dataclass(frozen=True, slots=True)
class KnownParameter:
    name: str
    """Where `is_tail`, what follows a part that is known at run time only, with the sign between them."""
    is_tail: bool
    type: str
    """bool, int, double or string, with `[]` for a list of them; "" where it is unknown, or releases differ.

    Releases of one distribution may differ, too: those are in a table of their own.
    """

    @property
    def key(self) -> str:
        """How a table of defaults names it."""
        return f"{TAIL if self.is_tail else ''}{self.name}"

    def fits(self, name: str) -> bool:
        """Return whether a parameter of this name is this one."""
        if not self.is_tail:
            return name == self.name
        return name.endswith(self.name if self.name[0] in "._" else f".{self.name}")


def known_nodes() -> dict[str, tuple[str, ...]]:
    """Return the names of the nodes that everybody gives parameters to, with their packages."""
    return rows(NAMES)


@cache
def known_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declares; nothing for any other."""
    changed = tuple(map(known_parameter, rows(CHANGED).get(package, ())))
    replaced = {each.key for each in changed}
    known = map(known_parameter, rows(TABLE).get(package, ()))
    return (*(each for each in known if each.key not in replaced), *changed)


@cache
def newer_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declares from Iron, Jazzy or later on; Humble has it nowhere."""
    return tuple(map(known_parameter, rows(NEWER).get(package, ())))


@cache
def removed_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declared before the oldest supported distribution, and no more."""
    return tuple(map(known_parameter, rows(TABLE, "removed").get(package, ())))


def known_parameter(word: str) -> KnownParameter:
    name, _, kind = word.partition(":")
    brackets = kind[1:]
    return KnownParameter(name.removeprefix(TAIL), name.startswith(TAIL), TYPES[kind[0]] + brackets if kind else "")


OF_LAYERS = {"inflation_radius": "0.55", "max_obstacle_height": "2.0"}
"""What parameters of the layers of a costmap are where nothing is given, whose names their sources have too."""
BY_HAND: dict[str, dict[str, str]] = {
    "nav2_costmap_2d": {f"{TAIL}.{name}": default for name, default in OF_LAYERS.items()},
    "turtlesim": {"background_b": "255", "background_g": "86", "background_r": "69"},
}
"""Defaults that are constants in the code, or that another declaration of the name has otherwise."""


@cache
def table_of_defaults(package: str) -> dict[str, str]:
    words = (word.partition("=") for table in OF_TABLES for word in rows(table).get(package, ()))
    return {name: value for name, _, value in words}


def default_of(package: str, name: str) -> str:
    """Return the default of a parameter of a well-known package, of a node or a plugin; "" where none is known.

    Of the declarations that a name fits the closest count: the whole name, else the longest end of it.
    """
    fitting = [each for each in known_parameters(package) if each.fits(name)]
    closest = max(map(closeness, fitting), default=None)
    found = {table_of_defaults(package).get(each.key, "") for each in fitting if closeness(each) == closest}
    default = found.pop() if len(found) == 1 else ""
    by_hand = name if "." not in name else f"{TAIL}.{name.partition('.')[2]}"
    return default or BY_HAND.get(package, {}).get(by_hand, "")


def closeness(known: KnownParameter) -> tuple[bool, int]:
    return not known.is_tail, len(known.name.lstrip("."))


def is_same_value(text: str, default: str) -> bool:
    """Return whether a value is written as a default, or is the same number."""
    if not default or text.strip("\"'").lower() == default.lower():
        return bool(default)
    try:
        return float(text) == float(default)
    except ValueError:
        return False
