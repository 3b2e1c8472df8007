"""A robot description as rules see it: links, joints, and the files that it refers to."""

from __future__ import annotations

from typing import Literal

from ...languages.xml.parser import Document, Element
from ...light_dataclasses import dataclass
from ...source import Source, Span

Use = Literal["include", "resource"]


@dataclass(frozen=True, slots=True)
class ResourceReference:
    """A file that is named by its package: `package://pkg/path`, `$(find pkg)/path`."""

    span: Span
    """From the scheme to the end of the path."""
    path_span: Span
    package: str
    path: str | None
    """Below the package's share folder; None where a part of it is filled in later."""
    use: Use


@dataclass(frozen=True, slots=True)
class LocalInclude:
    """A file that xacro includes by a path relative to the including file; `path` is relative to the package."""

    span: Span
    path: str


@dataclass(frozen=True)
class RobotFile:
    document: Document
    is_xacro: bool
    """Whether xacro processes it first."""
    links: tuple[Element, ...] = ()
    joints: tuple[Element, ...] = ()
    references: tuple[ResourceReference, ...] = ()
    includes: tuple[LocalInclude, ...] = ()

    @property
    def source(self) -> Source:
        return self.document.source

    @property
    def path(self) -> str:
        return self.document.source.path
