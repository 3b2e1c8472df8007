"""Misspelt names that setuptools ignores: arguments of setup(), and groups of entry points."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.python.evaluate.values import Argument
from ...light_dataclasses import dataclass
from ...ros.setup_keywords import KEYWORDS, OF_PLUGINS
from ...suggest import near_names

SCRIPTS = ("console_scripts", "gui_scripts")


@dataclass(frozen=True, slots=True)
class MisspeltArgument:
    """An argument of setup() with the one that is intended."""

    argument: Argument
    intended: str


def intended_group(group: str) -> str:
    """Return the group of scripts that a group of entry points is near to; "" where it is one, or near to none."""
    if group in SCRIPTS:
        return ""
    plain = group.strip().lower().replace("-", "_").replace(" ", "_").replace(".", "_")
    return plain if plain in SCRIPTS else next(iter(near_names(plain, SCRIPTS)), "")


def misspelt_arguments(arguments: Iterable[Argument]) -> Iterator[MisspeltArgument]:
    """Yield the arguments of setup() that are misspellings of a known one that is not given."""
    every = list(arguments)
    free = KEYWORDS - {each.name for each in every}
    for each in every:
        if each.name and each.name not in KEYWORDS | OF_PLUGINS:
            near = near_names(each.name, free)
            if each.name in SCRIPTS or intended_group(each.name):
                yield MisspeltArgument(each, "entry_points")
            elif near:
                yield MisspeltArgument(each, near[0])
