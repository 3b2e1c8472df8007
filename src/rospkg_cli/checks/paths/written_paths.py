"""Paths in code and settings at which something is written: nothing is missing there before a program has run."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from ...lazy_regex import regex
from ...source import Span
from .home_path_texts import CPP

if TYPE_CHECKING:
    from .path_flow import PathFlow

LONGEST = 240
"""How many characters before a path may say what is done with it."""
MOST = 20
"""How many paths of one file are followed; a file with more of them is a table of paths."""
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


class WrittenPaths:
    """Of a text without comments; of C++ with its header or source."""

    def __init__(self, path: str, text: str, *halves: str) -> None:
        self.text, self.followed = text, 0
        self.whole = "\n".join((text, *halves))
        self.is_python, self.is_code = path.endswith(".py"), path.endswith((".py", *CPP))

    def has(self, place: Span) -> bool:
        """Return whether a path is shown to be one that a program writes."""
        before = self.text[max(0, place.start - LONGEST) : place.start]
        if is_in_writer(self.text, place.start, place.end) or any(each.search(before) for each in NAMED):
            return True
        self.followed += self.is_code
        return self.is_code and self.followed <= MOST and self.flow.is_written(place)

    @cached_property
    def flow(self) -> PathFlow:
        from .path_flow import PathFlow  # few files have such a path

        return PathFlow(self.whole, is_python=self.is_python)


def is_in_writer(text: str, start: int, end: int) -> bool:
    """Return whether what stands at a place is the file that a call there writes."""
    before = text[max(0, start - LONGEST) : start]
    is_opened = IN_OPEN.search(before) is not None and WRITE_MODE.match(text, end) is not None
    return is_opened or IN_WRITER.search(before) is not None
