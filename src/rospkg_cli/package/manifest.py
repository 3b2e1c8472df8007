"""package.xml as rules see it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ..files import ReaderInput
from ..languages.rep149_condition import may_hold
from ..languages.xml.parser import Attribute, Document, Element, Instruction, read_xml
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..ros.distros import Targets
from ..ros.manifest import ATTRIBUTES_OF_3, CONDITIONAL_TAGS, DEPENDENCY_TAGS, FORMATS, NEW_IN
from ..source import Source, Span
from ..unreadable import UnreadableError
from .dependency import Dependency
from .schema.schema import Verdict, validate

OF_AMENT = regex(r"ament_cmake\w*")
"""Build tools of packages that CMake builds."""


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
        text = self.declared_format.value.strip() if self.declared_format else "1"
        return int(text) if text.isdecimal() and len(text) < 4 else 0

    @property
    def declared_format(self) -> Attribute | None:
        return self.root.attributes.get("format")

    @cached_property
    def schema_format(self) -> int:
        """The format whose schema is used: its own; 3 where there is no such format, or where newer tags are used."""
        if self.declared_format is not None:
            return self.format if self.format in FORMATS else max(FORMATS)
        newer = {tag for tags in NEW_IN.values() for tag in tags}
        return max(FORMATS) if self.all(*newer) else 1

    @cached_property
    def verdict(self) -> Verdict:
        """The result of the schema's validation."""
        return validate(self.document, self.schema_format)

    @cached_property
    def features_of_3(self) -> tuple[tuple[Element, Attribute | None], ...]:
        """What only format 3 has: groups, and attributes with the element that has them."""
        groups = [(child, None) for child in self.all(*NEW_IN[3])]
        attributes = [
            (child, child.attributes[name])
            for child in self.root.children
            if (name := ATTRIBUTES_OF_3.get(child.tag, "")) in child.attributes
        ]
        return tuple(sorted([*groups, *attributes], key=lambda each: each[0].span.start))

    @cached_property
    def xml_model(self) -> Instruction | None:
        """The first `<?xml-model …?>` line."""
        return next((each for each in self.document.instructions if each.target == "xml-model"), None)

    def all(self, *tags: str) -> list[Element]:
        """Return the children that have one of some tags, in order."""
        if len(tags) == 1:
            return [*self.by_tag.get(tags[0], ())]
        return [child for child in self.root.children if child.tag in tags]

    def first(self, tag: str) -> Element | None:
        return next(iter(self.by_tag.get(tag, ())), None)

    @cached_property
    def by_tag(self) -> dict[str, list[Element]]:
        """The children by tag: rules ask for the name once for each dependency."""
        found: dict[str, list[Element]] = {}
        for child in self.root.children:
            found.setdefault(child.tag, []).append(child)
        return found

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
    def version_span(self) -> Span:
        found = self.first("version")
        return self.span(found) if found else self.root.open

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
        """Return whether there is a dependency of that name, under any condition."""
        return any(d.name == name and (not tags or d.tag in tags) for d in self.dependencies)

    @cached_property
    def exports(self) -> tuple[Element, ...]:
        return tuple(child for export in self.all("export") for child in export.children)

    @cached_property
    def conditions(self) -> tuple[Attribute, ...]:
        """Every `condition` that tools evaluate: of dependencies, groups and build types."""
        carriers = [*self.all(*CONDITIONAL_TAGS), *(e for e in self.exports if e.tag == "build_type")]
        found = [each.attributes["condition"] for each in carriers if "condition" in each.attributes]
        return tuple(sorted(found, key=lambda attribute: attribute.span))

    def build_types(self, targets: Targets) -> Iterator[Element]:
        """Yield the <build_type> elements that hold for one of the targets."""
        return (
            e for e in self.exports if e.tag == "build_type" and may_hold(e.get("condition"), targets.environments())
        )

    def build_type(self, targets: Targets) -> str:
        """Return the build type for colcon; where none is given that of the build tool, else `catkin` (REP-149).

        XML301 reports that none is given; other rules judge the package as if that were repaired.
        """
        found = list(self.build_types(targets))
        if found:
            return found[-1].text
        tools = {d.name for d in self.dependencies if d.tag == "buildtool_depend"}
        is_of_ament = any(OF_AMENT.fullmatch(name) for name in tools) and "catkin" not in tools
        is_forgotten = is_of_ament and not any(e.tag == "build_type" for e in self.exports)
        return "ament_cmake" if is_forgotten else "catkin"


def read_manifest(reading: ReaderInput) -> Iterator[Manifest]:
    """Read package.xml; raises UnreadableError where it is not well formed, or is about something else."""
    if reading.files.exists("package.xml"):
        yield manifest_of(reading.files.source("package.xml"))


def manifest_of(source: Source) -> Manifest:
    """Make a manifest of a text; raises UnreadableError."""
    document = read_xml(source)
    root = document.root
    if root.tag != "package":
        raise UnreadableError(source.path, root.open, ReadProblem.NO_PACKAGE, root.tag)
    return Manifest(document)
