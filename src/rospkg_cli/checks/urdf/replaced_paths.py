"""Rule input: paths in a robot that all launch files which open it replace before they pass the text on."""

from __future__ import annotations

from functools import cached_property

from ...languages.xml.parser import Document
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.urdf.robot_words import REPLACES, words_of
from ...source import Span
from .including_packages import names_file
from .launched_robots import LaunchedRobots, names

REPLACED = regex(
    r"\.replace\(\s*[rf]?(?:\"([^\"\n]+)\"|'([^'\n]+)')|\bsub\(\s*[rf]{0,2}(?:\"([^\"\n]+)\"|'([^'\n]+)')|"
    r"\bsed\b[^\n]*?s([|#,@])((?:(?!\5)[^\n]){3,})\5"
)
"""What a launch file replaces in a text: of `re.sub` and `sed`, a pattern that is mostly written as the text."""
SHORT = 4
"""Shorter texts are part of too many paths."""


@dataclass(frozen=True)
class ReplacedPaths:
    launched: LaunchedRobots

    def has(self, document: Document, place: Span) -> bool:
        """Return whether each launch file that names a robot replaces a part of the path at a place, and one does."""
        path, source = document.source.path, document.source
        line = source.text[source.text.rfind("\n", 0, place.start) + 1 : place.end]
        if "<xacro:include" in line:
            return False  # xacro includes files before it hands on a text
        name, own = path.rpartition("/")[2], self.launched.package.name
        found = [
            any(each in line for each in replaced)
            for words, text, replaced in self.launches
            if names(words, text, name)
        ]
        for facts in self.launched.workspace.packages:
            others = (words for words in facts.robot_words if facts.name != own and names_file(words, own, name))
            found += [REPLACES in words for words in others]
        return bool(found) and all(found)

    @cached_property
    def launches(self) -> tuple[tuple[frozenset[str], str, frozenset[str]], ...]:
        """The words, the text and the replaced parts of each launch file of the package."""
        return tuple((words_of(text), text, replaced_in(text)) for _, text in self.launched.launches)


def replaced_in(text: str) -> frozenset[str]:
    """Return what a launch file replaces, without the signs that a pattern puts before some letters."""
    found = (
        next((group for group in each.groups() if group and len(group) > 1), "") for each in REPLACED.finditer(text)
    )
    return frozenset(each.replace("\\", "") for each in found if len(each) >= SHORT)
