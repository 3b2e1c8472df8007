"""The words that an argument evaluates to: references to variables and escapes are resolved."""

from __future__ import annotations

import re
from collections.abc import Callable

from ...lazy_regex import regex
from ...light_dataclasses import replace
from .list_text import list_to_text, split_list
from .syntax import CommandArgument
from .values import MAX_TEXT, UNKNOWN, Value, Word

REFERENCE = regex(r"\$(ENV|CACHE)?\{|\}|\\(.)", re.DOTALL)
PLAIN_REFERENCE = regex(r"\$\{([^{}$\\]+)\}")
HOLE_AT_TEXT = regex(r";\0(?=[^;\0])|(?<=[^;\0])\0;")
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", ";": "\\;"}


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
