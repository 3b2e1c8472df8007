"""package.xml as rules see it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from ..ros.distros import Targets
from ..ros.manifest import DEPENDENCY_TAGS
from ..source import Source, Span
from .condition import ConditionError, parse_condition
from .files import Reading
from .xml import Document, Element, read_xml


@dataclass(frozen=True)
class Dependency:
    element: Element
    tag: str
    name: str
    span: Span
    """Of the name."""
    condition: str | None = None

    def active(self, targets: Targets) -> bool:
        """Return whether the condition holds for one of the targets; one that can't be read does not."""
        return holds(self.condition, targets)


@dataclass(frozen=True)
class Manifest:
    document: Document

    @property
    def source(self) -> Source:
        return self.document.source

    @property
    def path(self) -> str:
        return self.document.source.path

    @property
    def root(self) -> Element:
        return self.document.root

    @cached_property
    def format(self) -> int:
        """The format (1 where none is named, as REP-127 says); 0 for what is not a number."""
        text = (self.root.get("format") or "1").strip()
        return int(text) if text.isdecimal() and len(text) < 4 else 0

    def all(self, *tags: str) -> list[Element]:
        return [child for child in self.root.children if child.tag in tags]

    def first(self, tag: str) -> Element | None:
        return next(iter(self.all(tag)), None)

    def text(self, tag: str) -> str:
        """Return the text of the first child with a tag, "" where there is none."""
        found = self.first(tag)
        return found.text if found else ""

    def span(self, element: Element) -> Span:
        """Return the span of an element's text, or of the element where it has none."""
        return self.document.text_span(element)

    @property
    def name(self) -> str:
        return self.text("name")

    @property
    def version(self) -> str:
        return self.text("version")

    @property
    def name_span(self) -> Span:
        found = self.first("name")
        return self.span(found) if found else self.root.open

    @cached_property
    def dependencies(self) -> tuple[Dependency, ...]:
        """Every dependency, whatever its condition."""
        return tuple(
            Dependency(child, child.tag, child.text, self.span(child), child.get("condition"))
            for child in self.root.children
            if child.tag in DEPENDENCY_TAGS
        )

    def depends_on(self, name: str, tags: Sequence[str] = ()) -> bool:
        """Return whether a dependency of that name is there, under whatever condition."""
        return any(d.name == name and (not tags or d.tag in tags) for d in self.dependencies)

    @cached_property
    def exports(self) -> tuple[Element, ...]:
        return tuple(child for export in self.all("export") for child in export.children)

    def build_types(self, targets: Targets) -> Iterator[Element]:
        """Yield the <build_type> elements that hold for one of the targets."""
        return (e for e in self.exports if e.tag == "build_type" and holds(e.get("condition"), targets))

    def build_type(self, targets: Targets) -> str:
        """Return what colcon builds it as; `catkin` where nothing is said (REP-149)."""
        found = list(self.build_types(targets))
        return found[-1].text if found else "catkin"


def holds(condition: str | None, targets: Targets) -> bool:
    if condition is None:
        return True
    try:
        parsed = parse_condition(condition)
    except ConditionError:
        return False
    return any(parsed.holds(variables) for variables in targets.environments())


def read_manifest(reading: Reading) -> Iterator[Manifest]:
    """Read package.xml; raises UnreadableError where it is not well formed."""
    if reading.files.exists("package.xml"):
        yield Manifest(read_xml(reading.files.source("package.xml")))
