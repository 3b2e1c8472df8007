"""Undeclared Python imports: what is to be declared, and the places that import it."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...source import Span
from .brought_dependencies import Bringer


@dataclass(frozen=True, slots=True)
class ImportUse:
    """An import of a module, in the file at a path."""

    path: str
    span: Span
    module: str


@dataclass(frozen=True, slots=True)
class UndeclaredImport:
    """A dependency that is used and not declared: the name to declare, and where it is imported."""

    name: str
    places: tuple[ImportUse, ...]
    also_provides: tuple[str, ...] = ()
    """Other undeclared names that come with this one."""
    bringer: Bringer | None = None
    """The declared dependency that it comes with today, or may come with."""
