"""One single fault: which files it changes, and by what names a finding may call it."""

from __future__ import annotations

import re
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace


@dataclass(frozen=True)
class PutFault:
    path: str
    """The file at fault, below the repository."""
    names: tuple[str, ...]
    """What a finding may name: the right name, the wrong one, or a file (its last part)."""
    files: Mapping[str, bytes | None]
    """Files as they are afterwards, below the repository; None: the file is gone."""
    line: int = 0
    """The first line that changes; 0: no single one."""
    not_executable: frozenset[str] = field(default_factory=frozenset)
    """Files that lose their executable bit."""
    excluded: str = ""
    """Why nothing fails, or why nobody could know; "": it counts."""

    def known(self, is_known: bool, why_not: str) -> PutFault:
        """Return the fault, excluded for a reason where what tells of it is not known to anybody."""
        return self if is_known else replace(self, excluded=why_not)


@dataclass(frozen=True)
class Spot:
    path: str
    text: str
    match: re.Match[str]
    group: int

    @property
    def word(self) -> str:
        return self.match[self.group]

    def __getitem__(self, group: int | str) -> str:
        return self.match[group] or ""

    def typo(self, *names: str) -> PutFault:
        """Return the fault of one mistyped word."""
        return self.put(typo(self.word), *names)

    def put(self, new: str, *names: str) -> PutFault:
        """Return the fault of another text in place of the word; both are names of it, where they are words."""
        start, end = self.match.span(self.group)
        both = [each for each in (self.word, new) if 1 < len(each) < 80 and "\n" not in each]
        return self.rewritten(self.text[:start] + new + self.text[end:], *names, *both)

    def drop_line(self, *names: str) -> PutFault:
        """Return the fault of the lines of the whole match being lost."""
        start, end = self.match.span()
        start = self.text.rfind("\n", 0, start) + 1
        end = self.text.find("\n", max(end - 1, start)) + 1 or len(self.text)
        return self.rewritten(self.text[:start] + self.text[end:], self.word, *names)

    def drop(self, *names: str) -> PutFault:
        """Return the fault of the whole match being lost, and nothing else of its lines."""
        start, end = self.match.span()
        return self.rewritten(self.text[:start] + self.text[end:], self.word, *names)

    def of_file(self, new: str) -> PutFault:
        """Return the fault of another text in place of the word, which a finding may name by its file."""
        return self.put(new, self.path.rsplit("/", 1)[-1])

    def rewritten(self, text: str, *names: str) -> PutFault:
        line = self.text.count("\n", 0, self.match.start(self.group)) + 1
        return PutFault(self.path, tuple(dict.fromkeys(names)), {self.path: text.encode()}, line)


def typo(word: str) -> str:
    """Return a word with two letters swapped, one lost, or one doubled: always the same for the same word."""
    letters = [i for i in range(1, len(word) - 1) if word[i].isalpha() and word[i + 1].isalpha()]
    letters = letters or [i for i in range(len(word)) if word[i].isalnum()]
    if not letters:
        return word + "x"
    number = zlib.crc32(word.encode())
    at = letters[number // 3 % len(letters)]
    if number % 3 == 0 and at + 1 < len(word) and word[at] != word[at + 1]:
        return word[:at] + word[at + 1] + word[at] + word[at + 2 :]
    if number % 3 == 1 and len(word) > 4:
        return word[:at] + word[at + 1 :]
    return word[: at + 1] + word[at] + word[at + 1 :]
