"""Formatting of package.xml, as `rospkg format` does it."""

from __future__ import annotations

from lsprotocol import types
from pygls.workspace import PositionCodec

from ...edits.format_manifest import format_edits
from ...source import Source
from ...unreadable import UnreadableError
from .positions import span_range


def formatting(text: str, codec: PositionCodec) -> list[types.TextEdit]:
    """Return the edits that bring a manifest into canonical order; none where it can't be read."""
    source = Source("package.xml", text.replace("\r\n", "\n"))
    try:
        found = format_edits(source)
    except UnreadableError:
        return []
    return [types.TextEdit(span_range(codec, source, each.span.start, each.span.end), each.text) for each in found]
