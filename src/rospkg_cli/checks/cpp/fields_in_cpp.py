"""Fields that C++ sets or reads and that the message does not have (IDL013)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.interface_fields import ros1_fields
from ...source import Span
from ..depends.compiled_sources import compiled_sources, harm_in
from ..fault import Level
from ..interfaces.field_names import similar
from ..interfaces.known_interfaces import KnownInterfaces
from .named_members import named_members


@dataclass(frozen=True, slots=True)
class WrongField:
    path: str
    span: Span
    message: str
    """`package/msg/Name`."""
    name: str
    near: str | None
    level: Level
    """How bad it is, by who compiles the file."""


@dataclass(frozen=True)
class FieldsInCpp:
    known: KnownInterfaces
    cmake: CMake
    sources: tuple[CppFile, ...]

    def wrong(self) -> Iterator[WrongField]:
        for source, role in compiled_sources(self.cmake, self.sources):
            text = source.source.text
            if role != "aside" and any(self.may_lack(each) for each in named_members(source.source)):
                yield from self.in_text(source, code_text(text))  # which takes longer

    def may_lack(self, members: tuple[frozenset[str], tuple[str, ...]]) -> bool:
        """Return whether one of some members, each of the one before, is reported for any of the messages."""
        if members not in self._lacking:
            messages, names = members
            is_reported = any(self.first_wrong(message, names) is not None for message in messages)
            self._lacking[members] = is_reported and not any(self.has(message, names) for message in messages)
        return self._lacking[members]

    @cached_property
    def _lacking(self) -> dict[tuple[frozenset[str], tuple[str, ...]], bool]:
        return {}

    def has(self, message: str, names: tuple[str, ...]) -> bool:
        """Return whether a message is known to have the first of some members."""
        return bool(names) and names[0] in (self.fields(message) or {}) and self.first_wrong(message, names) is None

    def first_wrong(self, message: str, names: tuple[str, ...]) -> tuple[int, str, str | None] | None:
        """Return the first member that its message lacks, as far as that is certain: its place, the message, and the
        field that is near."""
        for at, name in enumerate(names):
            fields = self.fields(message) if message else None
            if fields is None:
                return None
            if name not in fields:
                is_here = self.known.is_here(message.partition("/")[0])
                near = similar(name, fields, is_certain=is_here)
                is_reported = not name.startswith("_") and (near or is_here or name in ros1_fields(message))
                return (at, message, near) if is_reported else None
            message = fields[name]
        return None

    def fields(self, message: str) -> Mapping[str, str] | None:
        if message not in self._fields:
            self._fields[message] = self.known.fields(message)
        return self._fields[message]

    @cached_property
    def _fields(self) -> dict[str, Mapping[str, str] | None]:
        return {}

    def in_text(self, source: CppFile, text: str) -> Iterator[WrongField]:
        from .member_paths import member_paths  # few packages need it
        from .message_variables import message_variables

        found: dict[Span, WrongField] = {}
        for variable in message_variables(text):
            for path in member_paths(text, variable):
                if (wrong := self.first_wrong(variable.message, path.names)) is not None:
                    at, message, near = wrong
                    level = harm_in(self.cmake, self.sources, source.path)
                    span = path.spans[at]
                    found[span] = WrongField(source.path, span, message, path.names[at], near, level)
        yield from (found[span] for span in sorted(found))
