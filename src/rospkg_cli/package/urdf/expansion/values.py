"""Values of properties, parameters and expressions of xacro, and the tables that hold them. (xacro: Table)"""

from __future__ import annotations

from itertools import count

from ....languages.xml.parser import Element
from ....light_dataclasses import dataclass, field
from ....source import Source, Span
from .macros import Macro


@dataclass(frozen=True, slots=True)
class XacroUnknown:
    """A value that depends on what is outside of the files; `text` is the same where the value certainly is."""

    text: str


@dataclass(frozen=True, slots=True)
class XacroPlace:
    """Where a text stands: the file, from the root of the run behind a `/` where it is another package's."""

    source: Source
    span: Span


@dataclass(frozen=True, slots=True)
class XacroText:
    """A property as it is written: xacro evaluates it where it is first read."""

    place: XacroPlace


@dataclass(frozen=True, slots=True, eq=False)
class XacroBlock:
    """Elements that a macro is given, or that a property holds."""

    element: Element
    scope: XacroScope
    source: Source
    """The file that they are in."""
    content_only: bool


NUMBERS = count()
Value = str | int | float | bool | XacroUnknown
Stored = Value | XacroText | XacroBlock


@dataclass(eq=False)
class XacroScope:
    """The names of the whole robot, or of one call of a macro."""

    parent: XacroScope | None = None
    names: dict[str, Stored] = field(default_factory=dict)
    macros: dict[str, Macro] = field(default_factory=dict)
    number: int = field(default_factory=NUMBERS.__next__)

    def home(self, name: str) -> XacroScope | None:
        """Return the innermost table that has a name."""
        at: XacroScope | None = self
        while at is not None and name not in at.names:
            at = at.parent
        return at

    def macro(self, name: str) -> Macro | None:
        at: XacroScope | None = self
        while at is not None and name not in at.macros:
            at = at.parent
        return at.macros[name] if at is not None else None

    @property
    def top(self) -> XacroScope:
        at = self
        while at.parent is not None:
            at = at.parent
        return at

    def visible(self) -> set[str]:
        """Return the names of properties and parameters that may be read here."""
        own = {name for name in self.names if not name.startswith("*")}
        return own | (self.parent.visible() if self.parent else set())

    def visible_macros(self) -> set[str]:
        return set(self.macros) | (self.parent.visible_macros() if self.parent else set())


def literal(text: str) -> Value:
    """Return what xacro takes a text for: a number or a truth value where it is one, else the text itself."""
    if len(text) >= 2 and text[0] == text[-1] == "'":
        return text[1:-1]
    if "_" in text:
        return text
    for kind in (int, float):
        try:
            return kind(text)
        except (ValueError, OverflowError):
            continue
    return {"true": True, "True": True, "false": False, "False": False}.get(text, text)


def truth(value: Value) -> bool | None:
    """Return what a condition is; None where that is unknown, or xacro refuses the value."""
    if isinstance(value, XacroUnknown):
        return None
    if not isinstance(value, str):
        return bool(value)
    found = literal(value)
    return bool(found) if isinstance(found, bool | int) else None


def shown(value: Value) -> str:
    """Return the text that a value becomes in an attribute."""
    return value.text if isinstance(value, XacroUnknown) else str(value)
