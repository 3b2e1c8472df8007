"""Which brackets and strings are around a place in Python or C++ code, in one pass over its text."""

from __future__ import annotations

from bisect import bisect_right

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span

STRING = regex(
    r"(?<!\w)[rRfFbBuUL]{0,2}(?:\"\"\"[\s\S]*?\"\"\"|'''[\s\S]*?'''"
    r"|\"[^\"\\\n]*(?:\\[\s\S][^\"\\\n]*)*\"|'[^'\\\n]*(?:\\[\s\S][^'\\\n]*)*')"
)
SIGN = regex(r"[()\[\]{},]")
NO_WORD = regex(r"[^\w.'\"]")
CLOSING = frozenset(")]}")
TOP = -1
"""Where no bracket is open."""


@dataclass(frozen=True, slots=True)
class BracketArgument:
    span: Span
    index: int
    opener: int


class CodeBrackets:
    """Brackets of a text without comments. In its strings nothing but words and points counts, for `f'{a}/b.txt'`."""

    def __init__(self, text: str) -> None:
        self.strings = [Span(*each.span()) for each in STRING.finditer(text)]
        self.code = STRING.sub(lambda found: NO_WORD.sub(" ", found[0]), text)
        self._starts = [each.start for each in self.strings]
        self._signs: list[int] = []
        self._open: list[int] = []
        self._closes: dict[int, int] = {}
        self._commas: dict[int, list[int]] = {TOP: []}
        self._read()

    def _read(self) -> None:
        opened = [TOP]
        for found in SIGN.finditer(self.code):
            at = found.start()
            if found[0] == ",":
                self._commas[opened[-1]].append(at)
                continue
            if found[0] not in CLOSING:
                opened.append(at)
                self._commas[at] = []
            elif len(opened) > 1:
                self._closes[opened.pop()] = at
            self._signs.append(at)
            self._open.append(opened[-1])

    def opener(self, at: int) -> int:
        """Return the place of the innermost bracket that is open before a place; TOP where there is none."""
        index = bisect_right(self._signs, at - 1)
        return self._open[index - 1] if index else TOP

    def end_of(self, opener: int) -> int:
        """Return where the bracket that opens at a place ends, behind its sign."""
        return self._closes.get(opener, len(self.code) - 1) + 1

    def argument(self, opener: int, at: int) -> BracketArgument:
        """Return what stands around a place between the commas of a bracket."""
        commas = self._commas[opener]
        index = bisect_right(commas, at)
        start = commas[index - 1] if index else opener
        end = commas[index] if index < len(commas) else self.end_of(opener) - 1
        return BracketArgument(Span(start + 1, end), index, opener)

    def string_around(self, at: int) -> Span | None:
        index = bisect_right(self._starts, at)
        found = self.strings[index - 1] if index else None
        return found if found is not None and at < found.end else None
