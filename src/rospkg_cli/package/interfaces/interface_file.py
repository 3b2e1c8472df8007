"""A .msg, .srv or .action file as rules see it: what it declares, and what rosidl refuses, with positions."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...source import Source, Span
from .grammar_problem import GrammarProblem


@dataclass(frozen=True, slots=True)
class FieldType:
    """The type of a field or a constant."""

    text: str
    """As it is written, with bounds and brackets."""
    span: Span
    base: str
    """Without package, bounds and brackets: `int32`, `Point`."""
    base_span: Span
    """Of package and name, without bounds and brackets."""
    package: str = ""
    """The package that is named; "" where none is."""
    is_primitive: bool = False
    string_bound: int | None = None
    is_array: bool = False
    size: int | None = None
    """The exact size of an array, or the largest one where it is bounded."""
    is_bounded: bool = False
    """Written with `<=`."""


@dataclass(frozen=True, slots=True)
class Member:
    """A field or a constant; `value` is the constant's, or the field's default, and None where there is none."""

    type: FieldType
    name: str
    name_span: Span
    is_constant: bool = False
    value: str | None = None
    value_span: Span | None = None


@dataclass(frozen=True, slots=True)
class MessageSection:
    """A message of its own: all of a .msg, the request or the response of a .srv, one of three parts of an .action."""

    suffix: str
    members: tuple[Member, ...]

    @property
    def fields(self) -> tuple[Member, ...]:
        return tuple(member for member in self.members if not member.is_constant)

    @property
    def constants(self) -> tuple[Member, ...]:
        return tuple(member for member in self.members if member.is_constant)


@dataclass(frozen=True)
class InterfaceFile:
    source: Source
    kind: str
    """`msg`, `srv` or `action`."""
    sections: tuple[MessageSection, ...]
    problems: tuple[GrammarProblem, ...]

    @property
    def path(self) -> str:
        return self.source.path

    @property
    def name(self) -> str:
        """The file's name without its suffix."""
        return self.path.rpartition("/")[2].rpartition(".")[0]

    @property
    def folder(self) -> str:
        return self.path.rpartition("/")[0]

    @property
    def members(self) -> Iterator[Member]:
        return (member for section in self.sections for member in section.members)

    @property
    def types(self) -> Iterator[FieldType]:
        """Every type that is no primitive, in order."""
        return (member.type for member in self.members if not member.type.is_primitive)
