"""What xacro makes of a robot: the elements, with what is wrong on the way."""

from __future__ import annotations

from enum import Enum

from ....languages.xml.parser import Element
from ....light_dataclasses import dataclass, field
from ....source import Source, Span
from .values import Value


class XacroProblem(Enum):
    MACRO = "no macro of this name"
    NAME = "no property or parameter of this name"
    ARGUMENT = "no argument of this name"
    PARAMETER = "the macro has no parameter of this name"
    MISSING = "a parameter without a default is not given"
    FEW_BLOCKS = "the macro takes more blocks"
    MANY_BLOCKS = "the macro takes fewer blocks"
    BLOCK = "no block of this name"
    CONDITION = "a condition that is neither true nor false"


@dataclass(frozen=True, slots=True)
class FoundProblem:
    kind: XacroProblem
    source: Source
    span: Span
    name: str
    known: frozenset[str]
    """The names that there are."""
    is_certain: bool
    """Whether xacro certainly gets here."""
    is_closed: bool
    """Whether all names that there may be are known."""
    macro: str = ""


@dataclass(frozen=True, slots=True)
class ExpandedAttribute:
    """The value of an attribute, and where it is written."""

    value: Value
    span: Span


@dataclass(eq=False)
class Node:
    """An element as xacro leaves it."""

    tag: str
    element: Element
    source: Source
    is_certain: bool
    calls: tuple[tuple[Source, Element], ...] = ()
    """The calls of macros that made it, the outermost first."""
    attributes: dict[str, ExpandedAttribute] = field(default_factory=dict)
    children: list[Node] = field(default_factory=list)

    def first(self, tag: str) -> Node | None:
        return next((child for child in self.children if child.tag == tag), None)


@dataclass
class Expansion:
    children: list[Node] = field(default_factory=list)
    problems: list[FoundProblem] = field(default_factory=list)
    is_open: bool = False
    """Whether there may be other elements, macros and properties, of files that are not here."""
    lacks_files: bool = False
    """Whether it includes files that are not here, or are not known."""
    reached: set[str] = field(default_factory=set)
    """The paths of the files that were read."""
    certain: set[str] = field(default_factory=set)
    """Those of them that xacro certainly reads."""
    ways: dict[tuple[str, Span], bool] = field(default_factory=dict)
    """Conditions and arguments that xacro reaches, by path and place: whether it may enter, or use the default."""
