"""Paths in code and settings at which something is written: nothing is missing there before a program has run."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex

LONGEST = 240
"""How many characters before a path may say what is done with it."""
QUOTE = r"(?:\b[rRfFuUbBL]{1,2})?[\"']"
WRITER = (
    r"(?:\bnp\.savez?\w*|\bnumpy\.savez?\w*|\btorch\.save|\bsavefig|\bimwrite|\bimsave|\bto_(?:csv|json|excel|pickle)"
    r"|\w*FileHandler|\bofstream(?:[ \t]+\w+)?|\bVideoWriter\w*|\bmakedirs|\bmkdir|\bcreate_director(?:y|ies)"
    r"|\bsavePCDFile\w*|\bwrite_(?:point_cloud|triangle_mesh|image))[ \t]*[({]\s*"
)
"""Calls and streams whose first argument is a file that they write, or a folder that they make."""
IN_WRITER = regex(rf"{WRITER}{QUOTE}?$")
IN_OPEN = regex(rf"\bopen\(\s*{QUOTE}?$")
WRITE_MODE = regex(r"[\"']?\s*,\s*(?:mode\s*=\s*)?[\"'][wax]")
OUTPUT = r"(?:out|outputs?|save|saving|logs?|logging|record(?:s|ing|ings|er)?|dump|export)"
WORD = rf"(?:\w+[_-])?{OUTPUT}(?:[_-]\w+)?"
NAMED = (
    regex(rf"(?i)(?<![\w-]){WORD}[\"']?\s*(?::\s*[\w:.]+\s*)?[=:,]\s*(?:[\w:.]+\(\s*)?{QUOTE}$"),
    regex(rf"(?i)(?<![\w-]){WORD}\s*:\s*$"),
    regex(rf"(?i)\bname\s*=\s*[\"']{WORD}[\"']\s+(?:default|value)\s*=\s*[\"']$"),
    regex(rf"(?i)[\"']-*{WORD}[\"']\s*,[^()\"']*\bdefault(?:_value)?\s*=\s*{QUOTE}$"),
)
"""What stands before the value of a variable, key, parameter or argument whose name says that it is for an output."""
VARIABLE = regex(r"(?m)^[ \t]*(?:[\w:<>]+[ \t]+)?(\w+)[ \t]*=[ \t]*[\"']$")


def is_written(text: str, start: int, end: int) -> bool:
    """Return whether a path in some text, without comments, is shown to be one that a program writes."""
    before = text[max(0, start - LONGEST) : start]
    if is_in_writer(text, start, end) or any(each.search(before) for each in NAMED):
        return True
    variable = VARIABLE.search(before)
    uses = list(uses_of(variable[1], text, start)) if variable is not None else []
    return bool(uses) and all(is_in_writer(text, *each) for each in uses)


def is_in_writer(text: str, start: int, end: int) -> bool:
    """Return whether what stands at a place is the file that a call there writes."""
    before = text[max(0, start - LONGEST) : start]
    is_opened = IN_OPEN.search(before) is not None and WRITE_MODE.match(text, end) is not None
    return is_opened or IN_WRITER.search(before) is not None


def uses_of(name: str, text: str, bound: int) -> Iterator[tuple[int, int]]:
    """Yield where a name stands, but for the statement that binds it right before a place."""
    for found in re.finditer(rf"\b{re.escape(name)}\b", text):
        if text[found.end() : bound].strip(" \t=\"'") or found.start() > bound:
            yield found.span()
