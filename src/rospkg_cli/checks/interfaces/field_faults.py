"""Which unknown fields of messages are one fault (IDL010)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from .unknown_fields import UnknownField


def together(uses: Iterable[UnknownField]) -> Iterable[Sequence[Sequence[UnknownField]]]:
    """Return the uses by field, and the fields that are one fault: a message that the file takes for another.

    A field that has a near name is a fault of its own.
    """
    fields: dict[object, list[UnknownField]] = {}
    for use in uses:
        fields.setdefault((use.path, use.message, use.name, use.near), []).append(use)
    faults: dict[object, list[list[UnknownField]]] = {}
    for field in fields.values():
        first = field[0]
        how = (first.near, first.is_keyword, first.is_ros1, first.is_by_place)
        faults.setdefault((first.path, first.message, *how), []).append(field)
    return faults.values()
