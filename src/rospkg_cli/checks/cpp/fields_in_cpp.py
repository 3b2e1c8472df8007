"""Fields that C++ sets or reads and that the message does not have (IDL013)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.interface_fields import ros1_fields
from ...ros.interfaces import KINDS
from ...source import Span
from ..depends.compiled_sources import compiled_sources, own_compiled
from ..interfaces.known_interfaces import KnownInterfaces
from ..interfaces.unknown_fields import similar
from .message_variables import MemberPath, member_paths, message_variables


@dataclass(frozen=True, slots=True)
class WrongField:
    path: str
    span: Span
    message: str
    """`package/msg/Name`."""
    name: str
    near: str | None
    is_compiled: bool
    """Whether the package's own build certainly compiles the file."""


@dataclass(frozen=True)
class FieldsInCpp:
    known: KnownInterfaces
    cmake: CMake
    sources: tuple[CppFile, ...]

    def wrong(self) -> Iterator[WrongField]:
        for source, role in compiled_sources(self.cmake, self.sources):
            text = source.source.text
            if role == "aside" or not any(f"::{kind}::" in text for kind in KINDS):
                continue
            if any(True for _ in self.in_text(source, text)):  # before comments are found, which takes longer
                yield from self.in_text(source, code_text(text))

    def in_text(self, source: CppFile, text: str) -> Iterator[WrongField]:
        found: dict[Span, WrongField] = {}
        for variable in message_variables(text):
            for path in member_paths(text, variable):
                for each in self.judged(source, path):
                    found[each.span] = each
        yield from (found[span] for span in sorted(found))

    def judged(self, source: CppFile, path: MemberPath) -> Iterator[WrongField]:
        message = path.variable.message
        for name, span in zip(path.names, path.spans, strict=True):
            fields = self.known.fields(message) if message else None
            if fields is None:
                return
            if name in fields:
                message = fields[name]
                continue
            is_here = self.known.is_here(message.partition("/")[0])
            near = similar(name, fields, is_certain=is_here)
            if not name.startswith("_") and (near or is_here or name in ros1_fields(message)):
                is_compiled = self.compiled is not None and source.path in self.compiled
                yield WrongField(source.path, span, message, name, near, is_compiled)
            return

    @cached_property
    def compiled(self) -> set[str] | None:
        return own_compiled(self.cmake, self.sources)
