"""The head of a file: the comments, processing instructions and blanks before its first line of content."""

from __future__ import annotations

from ...lazy_regex import regex
from ...source import Source

BLANK = regex(r"[\ufeff\s]+")
REST_OF_LINE = regex(r"(?:#|//)[^\n]*")
MAX_STEPS = 20_000
"""So many blanks, comments and instructions are looked at in all; a head that goes on for longer is none."""


class FileHead:
    """Asked from the top of a file to its end, and read on from where the last answer left it."""

    def __init__(self, source: Source) -> None:
        self.text = source.text
        self.at = 0
        self.steps = 0

    def holds(self, place: int) -> bool:
        """Return whether nothing but comments, instructions and blanks is before an offset.

        A comment of XML that is open there counts as one.
        """
        at, certain = self.at, True
        while at < place:
            self.steps += 1
            end = self.step(at, place)
            if end is None or self.steps > MAX_STEPS:
                return False
            certain = certain and end == abs(end)
            at = abs(end)
            if certain:
                self.at = at
        return True

    def step(self, at: int, place: int) -> int | None:
        """Return where the next piece ends, negative where that hangs on the place; None at what says something."""
        text = self.text
        if blank := BLANK.match(text, at, place):
            return blank.end()
        if text.startswith("<!--", at):
            end = text.find("-->", at + 4, place)
            return end + 3 if end != -1 else -(at + 4)
        if text.startswith("<?", at):
            end = text.find("?>", at + 2, place)
            return end + 2 if end != -1 else None
        if text[text.rfind("\n", 0, at) + 1 : at].strip():
            return None
        rest = REST_OF_LINE.match(text, at)
        return None if rest is None else rest.end() if rest.end() <= place else -place
