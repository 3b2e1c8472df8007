"""Lines of package.xml that a template left, and which of them make one finding."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...languages.xml.elements import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...source import Source, Span
from .placeholders import EMAIL, NAMES, TODO

WANTED = "say in one sentence what the package does"
IGNORES = regex(r"rospkg:[ \t]*ignore\[")


@dataclass(frozen=True, slots=True)
class LeftLine:
    span: Span
    message: str
    name: str
    """Its name in the message of another line."""
    is_grave: bool = False


def joined(source: Source, lines: Sequence[LeftLine]) -> Iterator[tuple[LeftLine, ...]]:
    """Yield the lines that make one finding; the first of the most severe ones comes first, and has the finding.

    Another line with an ignore comment is a finding of its own, so that the comment has an effect.
    """
    if not lines:
        return
    lines = sorted(lines, key=lambda each: each.span.start)
    first = next((each for each in lines if each.is_grave), lines[0])
    others, alone = list[LeftLine](), list[LeftLine]()
    for each in lines:
        if each is not first:
            (alone if is_ignored(source.text, each.span.start) else others).append(each)
    yield first, *others
    yield from ((each,) for each in alone)


def is_ignored(text: str, offset: int) -> bool:
    """Return whether the line of an offset, or the one above, holds an ignore comment."""
    own = text.rfind("\n", 0, offset) + 1
    above = text.rfind("\n", 0, max(own - 1, 0)) + 1
    end = text.find("\n", offset)
    return IGNORES.search(text[above : end if end >= 0 else len(text)]) is not None


def descriptions(manifest: Manifest) -> Iterator[LeftLine]:
    for element in manifest.all("description"):
        shown = shown_text(element)
        if TODO.fullmatch(shown):
            said = f"the description says `{shown}`"
        elif repeats(manifest.name, shown):
            said = "the description only repeats the package's name"
        else:
            continue
        yield LeftLine(manifest.span(element), f"{said}; {WANTED}", "the description")


def people(manifest: Manifest) -> Iterator[LeftLine]:
    for element in manifest.all("maintainer", "author"):
        email = element.attributes.get("email")
        if email and EMAIL.fullmatch(email.value):
            message = f"`{email.value}` is a template's address; write the {element.tag}'s own"
            yield LeftLine(email.value_span, message, f"the address `{email.value}`")
        elif element.text.upper() in NAMES:
            message = f"the {element.tag} is called `{element.text}`; write a name"
            yield LeftLine(manifest.span(element), message, f"the {element.tag} `{element.text}`")


def shown_text(element: Element) -> str:
    return "".join(piece for each in element.walk() for piece in each.chunks).strip()


def repeats(name: str, text: str) -> bool:
    """Return whether a description is the template's `The my_pkg package`, or the name and nothing else."""
    return re.fullmatch(rf"(the )?{re.escape(name)}( package)?\.?", text, re.IGNORECASE) is not None
