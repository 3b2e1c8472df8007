"""New elements of package.xml that come to one place: in order, each once, kinds as far apart as the file has them."""

from __future__ import annotations

from collections.abc import Iterable

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..ros.manifest import DEPENDENCY_TAGS, place_of

LINE = r"(?P<text><(?P<tag>\w+)[^<>]*>(?P<name>[^<>]*)</(?P=tag)>)"
LED = regex(rf"(?P<before>\s+){LINE}(?P<behind>)")
FOLLOWED = regex(rf"(?P<before>){LINE}(?P<behind>\s*)")
FIRST_TAG = regex(r"\s*<(\w+)")


@dataclass(frozen=True)
class NewElement:
    """An element to be put in, with the blanks before it and behind it: one of them is empty."""

    before: str
    text: str
    behind: str
    tag: str
    name: str

    @property
    def rank(self) -> tuple[int, int, str]:
        kind = DEPENDENCY_TAGS.index(self.tag) if self.tag in DEPENDENCY_TAGS else 0
        return (place_of(self.tag), kind, self.name)


def in_order(texts: Iterable[str]) -> str:
    """Return what is put in at one place of package.xml as one text: by tags and names, one line for each of a kind."""
    elements = {each.text: each for text in texts for each in elements_of(text)}
    ordered = sorted(elements.values(), key=lambda each: each.rank)
    found = []
    for last, each, following in zip([None, *ordered], ordered, [*ordered[1:], None], strict=False):
        before = tight(each.before) if last and last.tag == each.tag else each.before
        behind = tight(each.behind) if following and following.tag == each.tag else each.behind
        found.append(before + each.text + behind)
    return "".join(found)


def elements_of(text: str) -> Iterable[NewElement]:
    """Return the dependencies that a text holds; a text that holds something else is one element."""
    parts = [*(FOLLOWED if text.startswith("<") else LED).finditer(text)]
    if "".join(part[0] for part in parts) != text or any(part["tag"] not in DEPENDENCY_TAGS for part in parts):
        start = FIRST_TAG.match(text)
        return [NewElement("", text, "", start[1] if start else "", "")]
    return [NewElement(*part.group("before", "text", "behind", "tag", "name")) for part in parts]


def tight(blanks: str) -> str:
    """Return blanks without the blank lines in them."""
    return blanks[blanks.rfind("\n") :] if "\n" in blanks else blanks
