"""Between our locations (lines and columns from 1, in code points) and those of an editor (from 0, in its own units).

An editor counts UTF-16 code units where it does not ask for others.
"""

from __future__ import annotations

from lsprotocol import types
from pygls.workspace import PositionCodec

from ...finding import Location
from ...source import Source


def to_position(codec: PositionCodec, source: Source, line: int, column: int) -> types.Position:
    """Return the editor's position of a line and a column."""
    start = source.offset(line, 1)
    return types.Position(line - 1, codec.client_num_units(source.text[start : source.offset(line, column)]))


def to_range(codec: PositionCodec, source: Source, at: Location) -> types.Range:
    """Return the editor's range of a location."""
    end = to_position(codec, source, at.end_line, at.end_column)
    return types.Range(to_position(codec, source, at.line, at.column), end)


def span_range(codec: PositionCodec, source: Source, start: int, end: int) -> types.Range:
    """Return the editor's range of two offsets."""
    first, last = source.position(start), source.position(end)
    return types.Range(to_position(codec, source, *first), to_position(codec, source, *last))


def to_offset(codec: PositionCodec, source: Source, position: types.Position) -> int:
    """Return the offset in a text of an editor's position; one behind the end of a line is that end."""
    if position.line >= len(source.line_starts):
        return len(source.text)
    line = source.line_span(position.line + 1)
    units = 0
    for number, letter in enumerate(source.slice(line)):
        if units >= position.character:
            return line.start + number
        units += codec.client_num_units(letter)
    return line.end
