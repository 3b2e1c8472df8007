"""Parameters that do nothing as another one switches them off, so that a dropped value changes nothing (PRM007)."""

from __future__ import annotations

from collections.abc import Iterable

from ...ros.known_nodes import default_of
from ...ros.parameter_switches import switches_of
from .known_group import KnownGroup

OFF = "false"


def why_off(group: KnownGroup, name: str) -> str:
    """Return why a parameter of the node or plugin of a group does nothing; "" where it may do something."""
    found = [off_switch(package, name, group) for package in group.packages]
    return f", and nothing differs while {found[0]}" if found and all(found) else ""


def off_switch(package: str, name: str, group: KnownGroup) -> str:
    for switch, is_of_group in switches_of(package, name):
        given = [each.plain for each in group.values if each.name == switch]
        if given and is_off(given):
            return f"`{switch}` is false"
        if not given and not is_of_group and default_of(package, switch).lower() == OFF:
            return f"`{switch}` is false, as by default"
    return ""


def is_off(given: Iterable[str | None]) -> bool:
    return all(text is not None and text.lower() == OFF for text in given)
