"""Values of CMake variables: lists of words, each with its position; UNKNOWN stands in for unknown parts.

A text is an ordinary string with a few private characters in it, none of which a CMake file can hold.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...source import Span
from .syntax import CommandArgument

UNKNOWN = "\0"
"""An unknown part of a text. A word that consists of it alone may be any number of words."""
SOURCE = "/\1source"
"""The folder of the package."""
BINARY = "/\1binary"
"""The build folder."""
PREFIX = "/\1prefix"
"""The install prefix."""
MAX_TEXT = 100_000
MAX_WORDS = 5_000

REFERENCE = regex(r"\$(ENV|CACHE)?\{|\}|\\(.)", re.DOTALL)
PLAIN_REFERENCE = regex(r"\$\{([^{}$\\]+)\}")
HOLE_AT_TEXT = regex(r";\0(?=[^;\0])|(?<=[^;\0])\0;")
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", ";": "\\;"}


@dataclass(frozen=True, slots=True)
class Word:
    text: str
    path: str
    """The file of the argument."""
    span: Span
    """The argument that it comes from, with its quotes."""
    maybe: bool = False
    """It exists only under a condition that can't be evaluated."""
    quoted: bool = False

    @property
    def is_known(self) -> bool:
        """Whether the text is known: no unknown part, no generator expression."""
        return UNKNOWN not in self.text and "$<" not in self.text


Value = tuple[Word, ...]


def cost(words: Sequence[Word]) -> int:
    """Return the cost of reading some words: one for each, and one for every sixteen characters."""
    return len(words) + (sum(len(word.text) for word in words) >> 4)


def list_to_text(value: Sequence[Word]) -> str:
    """Return a list as CMake's string; UNKNOWN where that is unknown."""
    if any(word.maybe for word in value):
        return UNKNOWN
    if cost(value) > MAX_TEXT:
        return UNKNOWN
    text = ";".join(map(escape_element, (word.text for word in value)))
    return text if len(text) <= MAX_TEXT else UNKNOWN


def escape_element(text: str) -> str:
    """Return an element as it is written in a list: `;` needs no escape inside square brackets."""
    return text.replace(";", "\\;") if ";" in text and len(list(split_list(text))) > 1 else text


def split_list(text: str) -> Iterator[str]:
    """Yield the elements of a list: separated by `;`, unless it is escaped or inside square brackets."""
    if ";" not in text:
        yield text
        return
    depth, start, at = 0, 0, 0
    while at < len(text):
        char = text[at]
        if char == "\\" and text[at + 1 : at + 2] == ";":
            at += 1
        elif char in "[]":
            depth += 1 if char == "[" else -1
        elif char == ";" and depth == 0:
            yield text[start:at].replace("\\;", ";")
            start = at + 1
        at += 1
    yield text[start:].replace("\\;", ";")


def substitute(text: str, value_of: Callable[[str, str], str]) -> str:
    """Resolve references and escapes in one pass; `value_of` gets ("", "ENV" or "CACHE") and a name.

    The result is UNKNOWN where a reference is never closed, or the text is too long.
    """
    levels: list[list[str]] = [[]]
    kinds: list[str] = []
    at = 0
    for match in REFERENCE.finditer(text):
        levels[-1].append(text[at : match.start()])
        at = match.end()
        if match.group(2) is not None:
            levels[-1].append(ESCAPES.get(match.group(2), match.group(2)))
        elif match.group() != "}":
            levels.append([])
            kinds.append(match.group(1) or "")
        elif kinds:
            name, kind = "".join(levels.pop()), kinds.pop()
            levels[-1].append(UNKNOWN if UNKNOWN in name else value_of(kind, name))
        else:
            levels[-1].append("}")
    if kinds:
        return UNKNOWN
    pieces = [*levels[0], text[at:]]
    return "".join(pieces) if sum(map(len, pieces)) <= MAX_TEXT else UNKNOWN


def words_of(
    argument: CommandArgument, path: str, variable: Callable[[str], Value], env: Callable[[str], str]
) -> list[Word]:
    """Return the words that an argument evaluates to: one if it is quoted, else any number."""

    def value_of(kind: str, name: str) -> str:
        return env(name) if kind == "ENV" else list_to_text(variable(name))

    if argument.kind in ("bracket", "paren"):
        return [Word(argument.text, path, argument.span, quoted=argument.kind == "bracket")]
    if argument.kind == "quoted":
        text = without_uncertain_separators(substitute(argument.text.replace("\\\n", ""), value_of))
        return [Word(text, path, argument.span, quoted=True)]
    if whole := PLAIN_REFERENCE.fullmatch(argument.text):
        return [with_position(word, argument, path) for word in variable(whole.group(1)) if word.text]
    text = without_uncertain_separators(substitute(argument.text, value_of))
    return [Word(each, path, argument.span) for each in split_list(text) if each]


def without_uncertain_separators(text: str) -> str:
    """Return a text without the `;` between an unknown part and other text: the unknown part may be empty."""
    return HOLE_AT_TEXT.sub(UNKNOWN, text) if UNKNOWN in text and ";" in text else text


def with_position(word: Word, argument: CommandArgument, path: str) -> Word:
    """Return a word with a position: one that CMake made has none, and gets that of its use."""
    return replace(word, path=path, span=argument.span) if word.span.end == 0 else word


def as_value(words: Iterable[Word]) -> Value:
    """Return the list that a variable holds after it was set to these words."""
    found: list[Word] = []
    for word in words:
        if ";" in word.text:
            found += [replace(word, text=each) for each in split_list(word.text)]
        else:
            found.append(word)
    return () if len(found) == 1 and not found[0].text else limited(tuple(found))


def limited(value: Value) -> Value:
    """Return a list; UNKNOWN where it is too long to be kept."""
    return value if len(value) <= MAX_WORDS else (replace(value[0], text=UNKNOWN, maybe=False),)


def merge_branches(values: Sequence[Value]) -> Value:
    """Return what a variable holds after branches that ended with these values.

    Elements that only some branches have become `maybe`; UNKNOWN where no value contains all the others.
    """
    first = values[0]
    if all(texts(value) == texts(first) for value in values):
        return next((value for value in values if any(word.maybe for word in value)), first)
    longest = max(values, key=len)
    if not all(is_within(texts(value), texts(longest)) for value in values):
        return (replace(longest[0], text=UNKNOWN, maybe=False),)
    common = frozenset(range(len(longest))).intersection(*(certain_elements(value, longest) for value in values))
    return tuple(word if at in common else replace(word, maybe=True) for at, word in enumerate(longest))


def certain_elements(shorter: Value, longer: Value) -> frozenset[int]:
    """Return which elements of a list are certainly those of another, which is within it."""
    rest = enumerate(longer)
    found = ((next(at for at, there in rest if there.text == word.text), word) for word in shorter)
    return frozenset(at for at, word in found if not word.maybe)


def texts(value: Value) -> list[str]:
    return [word.text for word in value]


def is_within(shorter: Sequence[str], longer: Sequence[str]) -> bool:
    """Return whether the one is what is left of the other when elements are taken out."""
    rest = iter(longer)
    return all(each in rest for each in shorter)
