"""Backslashes in comments and strings: rosidl_adapter decodes them as Python escapes when it writes the .idl file."""

from __future__ import annotations

import re
import unicodedata

from ...lazy_regex import regex

ESCAPE = regex(r"\\(?:N\{[^}]*\}|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|[0-7]{1,3}|.)?", re.DOTALL)
SIMPLE = {"a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v", "\\": "\\", "'": "'", '"': '"'}
PAIR = regex(r"\\.", re.DOTALL)


def escape_fault(text: str) -> tuple[int, int] | None:
    """Return start and end of the first escape that stops the build; None where there is none.

    What is decoded is written in Latin-1 and read as UTF-8, as a string of OMG IDL, which may not break a line.
    """
    if "\\" not in text:
        return None
    decoded, at = [], 0
    for match in ESCAPE.finditer(text):
        char = decode(match.group()[1:])
        if char is None or any(ord(each) > 127 or each in "\n\r" for each in char):
            return match.start(), match.end()
        decoded += [text[at : match.start()], char]
        at = match.end()
    literal = "".join([*decoded, text[at:]]).replace('"', '\\"')
    rest = PAIR.sub("", literal)
    if '"' in rest or rest.endswith("\\"):
        return text.rindex("\\"), text.rindex("\\") + 1
    return None


def decode(escape: str) -> str | None:
    """Return the character of an escape, given without its backslash; None where Python refuses it."""
    if escape in SIMPLE:
        return SIMPLE[escape]
    if escape[:1] in ("x", "u", "U") and len(escape) > 1:
        code = int(escape[1:], 16)
        return chr(code) if code < 0x110000 else None
    if escape.startswith("N{"):
        try:
            return unicodedata.lookup(escape[2:-1])
        except KeyError:
            return None
    if escape[:1] and escape[0] in "01234567":
        return chr(int(escape, 8))
    return None if escape in ("", "x", "u", "U", "N") else "\\" + escape
