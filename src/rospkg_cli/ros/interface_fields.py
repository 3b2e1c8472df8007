"""The interfaces of packages that many use, with the fields and constants of their messages.

Later distributions may add to a package: what is not here and is near to nothing that is here may exist.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from .interfaces import SECTIONS
from .read_table import rows, sets

TABLE = "interface_fields.txt"


@cache
def known_interfaces() -> Mapping[str, Mapping[str, frozenset[str]]]:
    """Return the interfaces of each package of the table: package, kind (`msg`, `srv`, `action`), names."""
    found: dict[str, dict[str, set[str]]] = {}
    for message in rows(TABLE):
        package, kind, name = message.split("/")
        suffix = next((each for each in SECTIONS[kind] if each and name.endswith(each)), "")
        found.setdefault(package, {}).setdefault(kind, set()).add(name.removesuffix(suffix))
    return {package: {kind: frozenset(each) for kind, each in kinds.items()} for package, kinds in found.items()}


def known_fields(message: str) -> Mapping[str, str] | None:
    """Return the fields and constants of a message (`geometry_msgs/msg/Twist`), None where the table lacks it.

    Each with the message that it holds one of, as `package/msg/Name`; "" for all others.
    """
    words = rows(TABLE).get(message)
    if words is None:
        return None
    return {
        name: full_name(kind, message.partition("/")[0]) for name, _, kind in (each.partition(":") for each in words)
    }


def full_name(kind: str, package: str) -> str:
    """Return the name of a field's message as imports have it; "" for what is no message."""
    before, _, base = kind.rpartition("/")
    return f"{before or package}/msg/{base}" if base else ""


def ros1_fields(message: str) -> frozenset[str]:
    """Return the fields and methods that a message had in ROS 1 and has no longer."""
    return sets("interface_words.txt", "fields of ROS 1").get(message, frozenset())
