"""The code of a C++ text that is compiled for certain, at its offsets: all else is blank."""

from __future__ import annotations

from .lexer import DIRECTIVE, TOKEN, ConditionalStack


def code_text(text: str) -> str:
    """Return a text of the same length without comments, literals, preprocessor lines, and what is inside an `#if`.

    The include guard of a header counts for nothing. Ends of lines are blank too.
    """
    conditions, pieces, at = ConditionalStack(), [], 0
    for match in TOKEN.finditer(text):
        start, end = match.span()
        pieces.append(" " * (start - at) if conditions.conditional else text[at:start])
        pieces.append(" " * (end - start))
        at = end
        if text[start] == "#" and (found := DIRECTIVE.match(text, start)) is not None:
            conditions.step(found[1], text, found.end(), end)
    pieces.append(" " * (len(text) - at) if conditions.conditional else text[at:])
    return "".join(pieces)
