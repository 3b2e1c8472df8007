"""Convert offsets in UTF-8 bytes, in which parsers count, to offsets in characters."""

from __future__ import annotations

from bisect import bisect_right

from ..lazy_regex import regex

WIDE = regex(r"[^\x00-\x7f]")


class CharTable:
    """For each byte of a UTF-8 text and its end, the index of the character it belongs to: `table[byte]`.

    Only characters of more than one byte are listed; most texts have a few.
    """

    def __init__(self, text: str) -> None:
        self.starts: list[int] = []
        """The first byte of each wide character."""
        self.ends: list[int] = []
        """The first byte behind it, and below the index of the character there."""
        self.following: list[int] = []
        self.last = len(text)
        added = 0
        for match in WIDE.finditer(text):
            at = match.start()
            width = len(match[0].encode("utf-8", "surrogatepass"))
            self.starts.append(at + added)
            self.ends.append(at + added + width)
            self.following.append(at + 1)
            added += width - 1

    def __getitem__(self, byte: int) -> int:
        last = bisect_right(self.starts, byte) - 1
        found = self.following[last] + max(byte - self.ends[last], -1) if last >= 0 else byte
        return min(found, self.last)
