"""Names that a message accepts as fields, and the field that a wrong name is nearest to."""

from __future__ import annotations

from collections.abc import Mapping

from ...ros.interfaces import CONSTANT_NAME
from ...suggest import near_names, nearest

GENERATED = frozenset({"get_fields_and_field_types", "SLOT_TYPES", "check_fields"})
"""Attributes that rosidl generates for each message class, in addition to the fields."""
AROUND = {"_Feedback": ("feedback", "goal_id"), "_Result": ("result", "status")}
"""Fields of the messages that wrap the feedback and the result of an action, by the suffix of the wrapped message.

An action client receives the wrapping message; annotations often name the wrapped one.
"""


def is_generated(message: str, name: str) -> bool:
    """Return whether a name is no field, and still valid: generated, private, or a field of the wrapping message."""
    if name in GENERATED or name.startswith("_") or name.endswith("__DEFAULT"):
        return True
    return any(message.endswith(kind) and name in around for kind, around in AROUND.items())


def settable(fields: Mapping[str, str]) -> Mapping[str, str]:
    """Return the fields without the constants, whose names are in capitals: code can't assign to a constant."""
    return {name: kind for name, kind in fields.items() if not CONSTANT_NAME.fullmatch(name)}


def similar(name: str, fields: Mapping[str, str], *, is_certain: bool) -> str | None:
    """Return the one field that a name is nearest to, or None.

    Where the fields are not certain (another release of the message may have others), only a clear match counts. A name
    of one or two letters matches a field that differs in case alone; a name in lower case matches no constant.
    """
    fields = settable(fields) if name.islower() else fields
    alike = [each for each in fields if each.lower() == name.lower()]
    if not alike and len(name) > len("xy"):
        alike = near_names(name, fields, 1) if not is_certain else [near] if (near := nearest(name, fields)) else []
    return alike[0] if len(alike) == 1 else None
