"""Where a package.xml names a package: as its own, as a dependency, and as the tag of an export."""

from __future__ import annotations

from collections.abc import Iterator

from ..package.manifest import manifest_of
from ..source import Source, Span
from ..unreadable import UnreadableError
from .renamed_package import RenamedPackage


def in_manifest(source: Source, renamed: RenamedPackage, is_own: bool) -> Iterator[Span]:
    """Yield the places; nothing where the file is not well formed."""
    try:
        manifest = manifest_of(source)
    except UnreadableError:
        return
    if is_own and manifest.name == renamed.old:
        yield trimmed(source, manifest.name_span, renamed.old)
    described = manifest.first("description")
    if is_own and described and described.text in (f"The {renamed.old} package", renamed.old):
        yield trimmed(source, manifest.span(described), renamed.old)
    for each in manifest.dependencies:
        if each.name == renamed.old:
            yield trimmed(source, each.span, renamed.old)
    for element in manifest.exports:
        if element.tag == renamed.old:
            yield trimmed(source, element.span, renamed.old)
            whole = source.slice(element.span)
            if whole.rstrip("> \t\n").endswith(f"</{renamed.old}"):
                start = element.span.start + whole.rindex(renamed.old)
                yield Span(start, start + len(renamed.old))


def trimmed(source: Source, span: Span, name: str) -> Span:
    """Return the first place of a name in a span."""
    start = source.text.index(name, span.start)
    return Span(start, start + len(name))
