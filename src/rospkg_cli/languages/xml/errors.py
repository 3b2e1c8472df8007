"""Messages for XML that is not well formed."""

from __future__ import annotations

import re
from xml.parsers import expat

from ...lazy_regex import regex
from ...source import Source

CONFLICT = regex(r"^(<<<<<<<|>>>>>>>)(?= |$)", re.MULTILINE)

Code = expat.errors.codes
UNCLOSED = {Code[expat.errors.XML_ERROR_NO_ELEMENTS], Code[expat.errors.XML_ERROR_UNCLOSED_TOKEN]}
MISMATCH = Code[expat.errors.XML_ERROR_TAG_MISMATCH]
JUNK = Code[expat.errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT]
INVALID = Code[expat.errors.XML_ERROR_INVALID_TOKEN]
DECLARATION = Code[expat.errors.XML_ERROR_MISPLACED_XML_PI]


def describe_error(source: Source, code: int, at: int, inside: str, opened: int) -> tuple[int, str]:
    """Return the offset and the message of an error; expat reports `code` at `at`, inside a tag opened earlier.

    A merge conflict is reported as such, where it begins, in preference to other errors.
    """
    conflict = CONFLICT.search(source.text)
    if conflict:
        return conflict.start(), f"`{source.path}` holds a merge conflict (`{conflict.group()}`); resolve it"
    at = max(at, 0)
    if code in UNCLOSED and inside:
        at, why = opened, f"`<{inside}>` is never closed"
    else:
        why = explain_code(source.text, code, at, inside)
    return at, f"`{source.path}` is not well-formed XML: {why}"


def explain_code(text: str, code: int, at: int, inside: str) -> str:
    around = text[max(0, at - 40) : at + 1].rpartition("\n")[2]
    if not text.strip():
        return "the file is empty"
    if code == MISMATCH:
        found = re.match(r"[^\s<>/]*", text[at:])
        return f"`<{inside}>` is closed by `</{found.group() if found else ''}>`"
    if code == JUNK:
        return "something follows after the end of the root element"
    if code == DECLARATION:
        return "the `<?xml …?>` line must be the very first of the file"
    if code == INVALID and re.search(r"&[^;\s<>]*[^;]?$", around):
        return "a lone `&`; write `&amp;`"
    if code == INVALID and inside and re.search(r"<[^/!?\w]?$", around):
        return f"a `<` that begins no tag, inside `<{inside}>`; write `&lt;`"
    said = expat.ErrorString(code).replace("not well-formed (invalid token)", "an unexpected character")
    return said + (f", inside `<{inside}>`" if inside else "")
