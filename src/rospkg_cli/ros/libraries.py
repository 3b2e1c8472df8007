"""Libraries of the system: the rosdep keys that serve a header, what the linker gets, or a module of pkg-config."""

from __future__ import annotations

from collections.abc import Collection

from ..lazy_regex import regex
from .read_table import rows

TABLE = "libraries.txt"
STEM = regex(r"(?:lib)?([a-z]+[0-9]?[a-z]*)")
FEWEST = 3
"""Letters that a part of a name needs to tell a library."""


def keys_of_header(header: str) -> tuple[str, ...]:
    """Return the keys for a header, by its name or its first folder; nothing where none is known."""
    table, (folder, slash, _) = rows(TABLE, "headers"), header.partition("/")
    return table.get(header) or (table.get(folder, ()) if slash else ())


def keys_of_linked(name: str) -> tuple[str, ...]:
    """Return the keys for what the linker gets: `usb-1.0` of `-lusb-1.0`."""
    return rows(TABLE, "linked").get(name, ())


def keys_of_module(name: str) -> tuple[str, ...]:
    """Return the keys for a module of pkg-config."""
    return rows(TABLE, "modules").get(name, ())


def stem(name: str) -> str:
    """Return the part of a library's name that all its names share: `usb` of `libusb-1.0`, `boost` of `boost_regex`."""
    first, _, rest = name.lower().partition("/")
    found = STEM.match(rest if rest and name in rows(TABLE, "headers") else first)
    return found[1] if found and len(found[1]) >= FEWEST else first


def is_named_among(name: str, others: Collection[str]) -> bool:
    """Return whether one of some names speaks of a library: `cppzmq` of `zmq.hpp`."""
    part = stem(name)
    return any(part in other.lower() for other in others)
