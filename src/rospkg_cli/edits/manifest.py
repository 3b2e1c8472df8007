"""Edits of package.xml: add or remove one element, in the indentation of the file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ..finding import Edit
from ..languages.xml.elements import Element, XmlComment
from ..lazy_regex import regex
from ..package.dependency import Dependency
from ..package.manifest import Manifest
from ..ros.manifest import ONLY_ROS_2
from ..source import Span
from .dependency_lines import in_order
from .manifest_place import behind_left_out, comment_above, gap_before, gap_behind, neighbour, start_with_heading
from .manifest_tags import quoted

FOR_ROS_2 = regex(r"""\$ROS_VERSION\s*==\s*["']?2["']?""")
BLANK_ABOVE = regex(r"\n[ \t]*\n\Z")
BLANK_LINE = regex(r"[ \t]*\n")
END = regex(r"[ \t]*</package>")


def add_dependency(manifest: Manifest, tag: str, name: str, condition: str = "") -> Edit:
    """Add a dependency among those of its tag, sorted where they are sorted, and not below a comment of others."""
    condition = condition or condition_for(manifest, name) or ""
    attribute = f" condition={quoted(condition)}" if condition else ""
    return add_element(manifest, tag, f"<{tag}{attribute}>{escaped(name)}</{tag}>", name)


def condition_for(manifest: Manifest, name: str) -> str | None:
    """Return the condition under which others of ROS 2 are declared in a package of both, for one that ROS 1 lacks."""
    if not ONLY_ROS_2.fullmatch(name):
        return None
    conditions = [each.condition for each in manifest.dependencies if each.condition]
    return next((each for each in conditions if FOR_ROS_2.fullmatch(each.strip())), None)


def add_dependencies(
    manifest: Manifest, wanted: Iterable[tuple[str, str]], conditions: Mapping[str, str] | None = None
) -> tuple[Edit, ...]:
    """Add several dependencies, each a tag and a name; those that belong to one place are one edit.

    `conditions` are those of some names (REP-149).
    """
    texts: dict[Span, list[str]] = {}
    for tag, name in sorted(wanted):
        edit = add_dependency(manifest, tag, name, (conditions or {}).get(name, ""))
        texts.setdefault(edit.span, []).append(edit.text)
    return tuple(Edit(manifest.path, span, in_order(each)) for span, each in sorted(texts.items()))


def escaped(text: str) -> str:
    """Return character data for XML."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def add_element(manifest: Manifest, tag: str, text: str, name: str = "") -> Edit:
    """Put a child element of <package> at its place in the schema's order."""
    anchor, is_before = neighbour(manifest, tag, name)
    indent = indentation(manifest, anchor)
    if anchor is None:
        return Edit(manifest.path, Span(manifest.root.open.end, manifest.root.open.end), f"\n{indent}{text}")
    if is_before:
        at = anchor.span.start if anchor.tag == tag else start_with_heading(manifest, anchor)
        return Edit(manifest.path, Span(at, at), f"{text}\n{gap_before(manifest, tag, anchor)}{indent}")
    at = end_of_line(manifest, anchor)
    at = at if tag == anchor.tag else behind_left_out(manifest, anchor, at)
    return Edit(manifest.path, Span(at, at), f"\n{gap_behind(manifest, tag, anchor, at)}{indent}{text}")


def add_export(manifest: Manifest, text: str) -> Edit:
    """Put an element into <export>, which is made where there is none."""
    export = manifest.first("export")
    indent = indentation(manifest, export)
    inner = f"\n{indent}{indent or '  '}{text}"
    if export is None:
        return add_element(manifest, "export", f"<export>{inner}\n{indent}</export>")
    if export.is_self_closing or not export.nodes:
        start_tag = manifest.source.slice(export.open).rstrip("/> ")
        return Edit(manifest.path, export.span, f"{start_tag}>{inner}\n{indent}</export>")
    at = export.nodes[-1].span.end
    return Edit(manifest.path, Span(at, at), f"\n{indentation(manifest, export.nodes[0])}{text}")


def indentation(manifest: Manifest, sibling: Element | XmlComment | None) -> str:
    """Return the blanks before a sibling, or before the first child, or two."""
    element = sibling or next(iter(manifest.root.children), None)
    if element is None:
        return "  "
    line = manifest.source.line_span(manifest.source.position(element.span.start)[0])
    before = manifest.source.text[line.start : element.span.start]
    return before if not before.strip() else "  "


def end_of_line(manifest: Manifest, element: Element) -> int:
    """Return the end of an element, past blanks and a comment behind it in the same line."""
    rest = manifest.source.line_span(manifest.source.position(element.span.end)[0])
    behind = manifest.source.text[element.span.end : rest.end].strip()
    return rest.end if not behind or (behind.startswith("<!--") and behind.endswith("-->")) else element.span.end


def remove_element(manifest: Manifest, element: Element) -> Edit:
    """Remove an element, with its line where that holds nothing else, and with one of two blank lines around it.

    A comment right above it goes too, where a blank line or the end behind the element shows that it was for it alone.
    """
    source = manifest.source
    start = source.line_span(source.position(element.span.start)[0]).start
    end = source.line_span(source.position(element.span.end)[0]).end
    alone = not (source.text[start : element.span.start] + source.text[element.span.end : end]).strip()
    if not alone:
        return Edit(manifest.path, element.span, "")
    end = min(end + 1, len(source.text))
    if BLANK_LINE.match(source.text, end) or END.match(source.text, end):
        start = start_with_own_comment(manifest, element, start)
    blank = BLANK_LINE.match(source.text, end) if BLANK_ABOVE.search(source.text[:start]) else None
    return Edit(manifest.path, Span(start, blank.end() if blank else end), "")


def start_with_own_comment(manifest: Manifest, element: Element, start: int) -> int:
    """Return where the line of a comment right above an element begins, or `start`; one with markup is kept."""
    is_child = any(each is element for each in manifest.root.nodes)
    above = comment_above(manifest, element) if is_child else None
    if above is None or "<" in above.text or "\n" in above.text:
        return start
    return manifest.source.line_span(manifest.source.position(above.span.start)[0]).start


def rename_dependency(manifest: Manifest, dependency: Dependency, name: str) -> Edit:
    """Replace the name of a dependency."""
    return Edit(manifest.path, dependency.span, escaped(name))


def split_dependency(manifest: Manifest, dependency: Dependency, names: Iterable[str]) -> Edit:
    """Replace a dependency that names several by one for each, with the attributes that it has."""
    element = dependency.element
    start_tag = manifest.source.slice(element.open)
    lines = [f"{start_tag}{escaped(name)}</{element.tag}>" for name in names]
    return Edit(manifest.path, element.span, f"\n{indentation(manifest, element)}".join(lines))


def change_tag(manifest: Manifest, dependency: Dependency, tag: str) -> Edit:
    """Declare a dependency under another tag, with the attributes that it has."""
    return rename_element(manifest, dependency.element, tag)


def rename_element(manifest: Manifest, element: Element, tag: str) -> Edit:
    """Write an element with another tag, with all that it has."""
    text = manifest.source.slice(element.span)
    old = f"<{element.tag}"
    return Edit(manifest.path, element.span, text.replace(old, f"<{tag}").replace(f"</{element.tag}", f"</{tag}"))
