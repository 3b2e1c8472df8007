"""What is wrong where XML is not well formed."""

from __future__ import annotations

import re
from xml.parsers import expat

from ...lazy_regex import regex
from ...read_problem import ReadProblem
from ...source import Source

CONFLICT = regex(r"^(<<<<<<<|>>>>>>>)(?= |$)", re.MULTILINE)
STRAY_END = regex(r"</")
OPENED = regex(r"<[^\s<>/!?]")

Code = expat.errors.codes
UNCLOSED = {Code[expat.errors.XML_ERROR_NO_ELEMENTS], Code[expat.errors.XML_ERROR_UNCLOSED_TOKEN]}
MISMATCH = Code[expat.errors.XML_ERROR_TAG_MISMATCH]
JUNK = Code[expat.errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT]
INVALID = Code[expat.errors.XML_ERROR_INVALID_TOKEN]
DECLARATION = Code[expat.errors.XML_ERROR_MISPLACED_XML_PI]

Found = tuple[ReadProblem] | tuple[ReadProblem, str] | tuple[ReadProblem, str, str]
"""A problem and its details."""


def describe_error(source: Source, code: int, at: int, inside: str, opened: int) -> tuple[int, Found]:
    """Return the offset and the problem of an error; expat reports `code` at `at`, inside a tag opened earlier.

    A merge conflict is reported as such, where it begins, in preference to other errors.
    """
    conflict = CONFLICT.search(source.text)
    if conflict:
        return conflict.start(), (ReadProblem.XML_CONFLICT, conflict.group())
    at = max(at, 0)
    if code in UNCLOSED and inside:
        return opened, (ReadProblem.XML_OPEN, inside)
    return at, problem_of(source.text, code, at, inside)


def problem_of(text: str, code: int, at: int, inside: str) -> Found:
    around = text[max(0, at - 40) : at + 1].rpartition("\n")[2]
    if not text.strip():
        return (ReadProblem.XML_EMPTY,)
    if code == MISMATCH:
        found = re.match(r"[^\s<>/]*", text[at:])
        return ReadProblem.XML_MISMATCH, inside, found.group() if found else ""
    if code == JUNK or (code == INVALID and not inside and is_second_end(text, at)):
        return (ReadProblem.XML_AFTER_ROOT,)
    if code == DECLARATION:
        return (ReadProblem.XML_DECLARATION,)
    if code == INVALID and re.search(r"&[^;\s<>]*[^;]?$", around):
        return (ReadProblem.XML_AMPERSAND,)
    if code == INVALID and inside and re.search(r"<[^/!?\w]?$", around):
        return ReadProblem.XML_LESS_THAN, inside
    said = expat.ErrorString(code).replace("not well-formed (invalid token)", "an unexpected character")
    return (ReadProblem.XML_OTHER_INSIDE, said, inside) if inside else (ReadProblem.XML_OTHER, said)


def is_second_end(text: str, at: int) -> bool:
    """Return whether an end tag is written where no element is open, behind one that is closed."""
    return STRAY_END.search(text, max(0, at - 1), at + 1) is not None and OPENED.search(text, 0, at) is not None
