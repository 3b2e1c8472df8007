"""A command that was run: its arguments evaluated, each with its position."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Sequence
from functools import cached_property, lru_cache

from ...light_dataclasses import dataclass
from .syntax import CommandArgument, CommandInvocation
from .values import BINARY, SOURCE, UNKNOWN, Word


@dataclass(frozen=True)
class EvaluatedCommand:
    command: CommandInvocation
    words: tuple[Word, ...]
    path: str
    """The file of the command."""
    folder: str
    """CMAKE_CURRENT_SOURCE_DIR, relative to the package; "" for the package itself."""
    testing: bool = False
    """It runs only where BUILD_TESTING is on."""
    maybe: bool = False
    """It runs only under a condition that can't be evaluated."""
    function: str = ""
    """The function or macro of the package that contains it."""
    counts: tuple[int, ...] = ()
    """How many words each argument of the command evaluates to."""

    @cached_property
    def name(self) -> str:
        return self.command.name

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return tuple(word.text for word in self.words)

    def by_argument(self) -> Iterator[tuple[CommandArgument, tuple[Word, ...]]]:
        """Yield the arguments as they are written, each with the words that it evaluates to."""
        at = 0
        for argument, count in zip(self.command.arguments, self.counts, strict=True):
            yield argument, self.words[at : at + count]
            at += count

    @property
    def first(self) -> Word | None:
        return self.words[0] if self.words else None

    @property
    def may_have_more(self) -> bool:
        """Whether there may be more arguments than are known."""
        return any(word.text == UNKNOWN for word in self.words)


def by_keyword(words: Sequence[Word], keywords: Collection[str]) -> dict[str, list[Word]]:
    """Return the words behind each keyword; those before the first have the key ""."""
    found: dict[str, list[Word]] = {"": []}
    current = found[""]
    for word in words:
        if word.text in keywords:
            current = found.setdefault(word.text, [])
        else:
            current.append(word)
    return found


def flags_and_values(
    words: Sequence[Word], flags: Collection[str], single: Collection[str], many: Collection[str]
) -> tuple[set[str], dict[str, list[Word]], list[Word]]:
    """Parse arguments as cmake_parse_arguments does: the flags, the words of each keyword, and the rest.

    Quotes make no difference: `"ENV"` is `ENV`. A keyword that stands twice has the last of single values, and all of
    many.
    """
    found: set[str] = set()
    values: dict[str, list[Word]] = {}
    rest: list[Word] = []
    current, room = rest, -1
    for word in words:
        text = word.text
        if text in flags:
            found.add(text)
            current, room = rest, -1
        elif text in single or text in many:
            current = values.setdefault(text, [])
            room = 1 if text in single else -1
        else:
            if room == 1:
                current.clear()
            current.append(word)
            room -= 1
            if room == 0:
                current, room = rest, -1
    return found, values, rest


@lru_cache(maxsize=10_000)
def path_in_package(text: str, folder: str) -> str | None:
    """Return a path relative to the package ("" for the package itself).

    None where it is unknown, generated, or outside the package.
    """
    if UNKNOWN in text or "$<" in text or text.startswith(BINARY) or "\1" in text.removeprefix(SOURCE):
        return None
    if text.startswith(SOURCE):
        path = text[len(SOURCE) :].lstrip("/")
    elif text.startswith(("/", "~")):
        return None
    else:
        path = posixpath.join(folder, text)
    path = posixpath.normpath(path)
    return None if path == ".." or path.startswith("../") else "" if path == "." else path
