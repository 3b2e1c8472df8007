"""The fields of a package's messages, as other packages may know them."""

from __future__ import annotations

from ...files import ReaderInput
from ...light_dataclasses import dataclass
from ...ros.interface_fields import full_name
from ..manifest import Manifest
from .interface_file import InterfaceFile, Member


@dataclass(frozen=True, slots=True)
class MessageFields:
    """A message, or one part of a service or action."""

    name: str
    """`msg/Status`, `srv/SetMode_Request`, `action/Drive_Goal`."""
    fields: tuple[tuple[str, str], ...]
    """Each field and constant, with the message that it holds one of (`package/msg/Name`), "" for all others."""


def message_fields(reading: ReaderInput) -> tuple[MessageFields, ...]:
    """Return the messages of a package, without those that rosidl refuses."""
    manifest = reading.parts(Manifest).only
    package = manifest.name if manifest is not None else ""
    return tuple(
        MessageFields(
            f"{file.kind}/{file.name}{section.suffix}",
            tuple((member.name, message_of(member, package)) for member in section.members),
        )
        for file in reading.parts(InterfaceFile).good
        if not file.problems
        for section in file.sections
    )


def message_of(member: Member, package: str) -> str:
    kind = member.type
    if member.is_constant or kind.is_primitive or kind.is_array:
        return ""
    return full_name(f"{kind.package}/{kind.base}" if kind.package else kind.base, package)
