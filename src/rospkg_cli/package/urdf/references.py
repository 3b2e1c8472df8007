"""References of a robot description to files of packages, in attributes and texts."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from ...languages.xml.parser import Document, Element
from ...lazy_regex import regex
from ...source import Source, Span
from .robot_file import LocalInclude, ResourceReference, Use

NAMED = regex(
    r"package://(?P<package>[A-Za-z][A-Za-z0-9_-]*)(?P<rest>/[^\s<>\"']*)?"
    r"|\$\(find +(?P<found>[A-Za-z][A-Za-z0-9_-]*) *\)(?P<below>/[^\s<>\"']*)?"
)
PROPERTY = regex(r"\$\{ *([A-Za-z_][A-Za-z0-9_]*) *\}")
GLOB = regex(r"[*?\[]")


def references(document: Document) -> Iterator[ResourceReference]:
    """Yield every reference to a file of a package, in order."""
    properties = literal_properties(document.root)
    for element in document.root.walk():
        if is_optional(element):
            continue
        use: Use = "include" if element.tag == "xacro:include" else "resource"
        for attribute in element.attributes.values():
            is_file = attribute.name == "filename"
            yield from named_in(document.source, attribute.value_span, use, properties, is_file=is_file)
        if element.chunks and not element.is_self_closing:
            for span in text_spans(element):
                is_file = element.tag == "uri" and not element.children
                yield from named_in(document.source, span, use, properties, is_file=is_file)


def is_optional(element: Element) -> bool:
    """Return whether xacro goes on without the file that an element includes."""
    return element.tag == "xacro:include" and element.get("optional") is not None


def text_spans(element: Element) -> Iterator[Span]:
    """Yield the spans of the text directly inside an element."""
    at = element.inner.start
    for node in element.nodes:
        yield Span(at, node.span.start)
        at = node.span.end
    yield Span(at, element.inner.end)


def named_in(
    source: Source, span: Span, use: Use, properties: Mapping[str, str], *, is_file: bool = False
) -> Iterator[ResourceReference]:
    """Yield the references in a text; where the whole of it names a file, blanks are part of the name."""
    text = source.slice(span)
    for match in NAMED.finditer(text):
        package = match.group("package") or match.group("found")
        group = "rest" if match.group("package") else "below"
        rest = match.group(group) or ""
        start, end = match.span(group) if match.group(group) else (match.end(), match.end())
        if is_file and rest and not text[: match.start()].strip():
            rest, end = text[start:].rstrip(), len(text.rstrip())
        where = Span(span.start + start, span.start + end)
        yield ResourceReference(
            Span(span.start + match.start(), where.end), where, package, path_of(rest, properties), use
        )


def path_of(rest: str, properties: Mapping[str, str]) -> str | None:
    """Return the path below the share folder; None where a part of it is not literal."""
    filled = PROPERTY.sub(lambda match: properties.get(match.group(1), match.group()), rest)
    if "$" in filled or "{" in filled or GLOB.search(filled):
        return None
    return posixpath.normpath(filled.lstrip("/")) if filled.strip("/") else ""


def literal_properties(root: Element) -> dict[str, str]:
    """Return the properties that are set once, at the top of the file, to a text without substitutions."""
    found: dict[str, str] = {}
    count: dict[str, int] = {}
    for element in root.walk():
        if element.tag == "xacro:property" and (name := element.get("name")):
            count[name] = count.get(name, 0) + 1
            value = element.get("value")
            if value is not None and "$" not in value and element in root.children:
                found[name] = value
        for macro_parameter in (element.get("params") or "").split() if element.tag == "xacro:macro" else ():
            count[macro_parameter.split(":")[0].lstrip("*")] = 2
    return {name: value for name, value in found.items() if count[name] == 1}


def local_includes(document: Document) -> Iterator[LocalInclude]:
    """Yield what xacro includes by a relative path; nothing that is optional or filled in."""
    folder = posixpath.dirname(document.source.path)
    for element in document.root.walk():
        filename = element.attributes.get("filename")
        if element.tag != "xacro:include" or filename is None or is_optional(element):
            continue
        path = filename.value
        if path and not path.startswith(("/", "~", "package:")) and "$" not in path and not GLOB.search(path):
            yield LocalInclude(filename.value_span, posixpath.normpath(posixpath.join(folder, path)))
