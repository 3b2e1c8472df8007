"""Lists of CMake as one string, with `;` between the elements, and back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...light_dataclasses import replace
from .values import MAX_TEXT, UNKNOWN, Value, Word, cost, limited


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


def as_value(words: Iterable[Word]) -> Value:
    """Return the list that a variable holds after it was set to these words."""
    found: list[Word] = []
    for word in words:
        if ";" in word.text:
            found += [replace(word, text=each) for each in split_list(word.text)]
        else:
            found.append(word)
    return () if len(found) == 1 and not found[0].text else limited(tuple(found))
