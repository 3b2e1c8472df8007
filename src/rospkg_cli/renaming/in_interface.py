"""Where messages, services and actions name a package: before the types of fields."""

from __future__ import annotations

from collections.abc import Iterator

from ..source import Source, Span
from .patterns import found
from .renamed_package import RenamedPackage

FIELDS = (r"^[ \t]*%PART%(?=/\w)",)
IDL = (r"^[ \t]*module\s+%NAME%", r"""^[ \t]*#[ \t]*include[ \t]*[<"]%PART%(?=/)""")


def in_interface(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    yield from found(IDL if source.path.endswith(".idl") else FIELDS, source.text, renamed.old)
