"""The fields of an interface that a generated node sets, with a first value in each language."""

from __future__ import annotations

from collections.abc import Iterator

from ..package.interfaces.interface_file import Member
from .message import MessageField

PYTHON = {"bool": "False", "float": "0.0", "int": "0", "uint": "0", "string": "''"}
CPP = {"bool": "false", "float": "0.0", "int": "0", "uint": "0", "string": '""'}


def fields(members: tuple[Member, ...]) -> Iterator[MessageField]:
    """Yield the fields that have a plain value, and those that hold the time."""
    for member in members:
        type = member.type
        if type.is_array or member.value is not None:
            continue
        shown = f"{type.package}/{type.base}" if type.package else type.base
        if shown in ("builtin_interfaces/Time", "std_msgs/Header"):
            path = f"{member.name}.stamp" if type.base == "Header" else member.name
            yield MessageField(path, "builtin_interfaces/Time", "self.get_clock().now().to_msg()", "now()")
        kind = type.base.rstrip("0123456789")
        if type.is_primitive and kind in PYTHON:
            yield MessageField(member.name, type.text, PYTHON[kind], CPP[kind])
