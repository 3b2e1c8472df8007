"""package.xml in canonical order: the schema's, dependencies by tag and by name; nothing else about it changes."""

from __future__ import annotations

from ..finding import Edit
from ..package.manifest import manifest_of
from ..source import Source
from .reorder import canonical_order, reorder


def format_edits(source: Source) -> list[Edit]:
    """Return the edits that bring a manifest into canonical order; none where it is. Raises UnreadableError.

    Comments and conditions travel with their element. Where text stands between the elements, nothing is moved.
    """
    manifest = manifest_of(source)
    return reorder(manifest, canonical_order(manifest))


def format_text(text: str, path: str = "package.xml") -> str:
    """Return a manifest in canonical order; raises UnreadableError.

    >>> format_text("<package><depend>b</depend>\\n<depend>a</depend></package>")
    '<package><depend>a</depend>\\n<depend>b</depend></package>'
    """
    for edit in format_edits(Source(path, text)):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text
