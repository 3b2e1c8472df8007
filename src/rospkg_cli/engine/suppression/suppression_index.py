"""Suppress findings by ignore comments, and report the comments that are unused."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from itertools import islice

from ...finding import Finding
from ...light_dataclasses import dataclass, field, replace
from ...package.run_events import ReasonlessIgnore, UnknownRuleName, UnusedSuppression
from ...source import Span
from ...suggest import nearest
from ..selection import codes_named, rule_names
from .comments import Suppression

MAX_GUESSES = 100
"""Unknown rule names for which the nearest one is looked up: that takes time."""


@dataclass
class SuppressionIndex:
    """All ignore comments of a run; `ran_at` returns the codes of the rules that ran on the package of a path."""

    comments: Sequence[Suppression]
    ran_at: Callable[[str], frozenset[str]]
    used: set[tuple[int, int]] = field(default_factory=set)
    """The codes of comments that suppressed something: index of the comment, index of the code."""

    def __post_init__(self) -> None:
        self.by_place: dict[tuple[str, int], list[int]] = defaultdict(list)
        """Path and line (0 for the whole file) → the comments there."""
        self.by_code: dict[tuple[str, int], dict[str, tuple[int, int]]] = {}
        for index, comment in enumerate(self.comments):
            for line in comment.lines or (0,):
                self.by_place[comment.path, line].append(index)

    def apply(self, findings: Iterable[Finding]) -> list[Finding]:
        """Return all findings; those that a comment ignores have its reason."""
        return [self.suppressed(finding) for finding in findings]

    def suppressed(self, finding: Finding) -> Finding:
        places = ((finding.location.path, 0), (finding.location.path, finding.location.line))
        found = [found for place in places if (found := self.codes_at(place).get(finding.code)) is not None]
        if not found:
            return finding
        self.used.add(first := min(found))
        return replace(finding, suppressed=self.comments[first[0]].reason or "no reason given")

    def codes_at(self, place: tuple[str, int]) -> dict[str, tuple[int, int]]:
        """Return, for each code that is ignored at a position, the first comment that does so, and its name there."""
        if place not in self.by_code:
            found = self.by_code[place] = {}
            for index in self.by_place.get(place, ()):
                for at, name in enumerate(self.comments[index].codes):
                    for code in codes_named(name):
                        found.setdefault(code, (index, at))
        return self.by_code[place]

    def unknown(self) -> list[UnknownRuleName]:
        """Return the names in comments that name no rule."""
        names = rule_names()
        found = [
            (comment.path, span, name)
            for comment in self.comments
            for name, span in zip(comment.codes, comment.code_spans, strict=True)
            if not codes_named(name)
        ]
        different = dict.fromkeys(name for _, _, name in found)
        bare = [UnknownRuleName(each.path, each.span, "", None) for each in self.comments if not each.codes]
        suggestions = {name: nearest(name, names) for name in islice(different, MAX_GUESSES)}
        return [*bare, *(UnknownRuleName(path, span, name, suggestions.get(name)) for path, span, name in found)]

    def unused(self) -> list[UnusedSuppression]:
        """Return the codes in comments that ignored nothing although all of their rules ran."""
        found = []
        for index, comment in enumerate(self.comments):
            unused = [at for at, name in enumerate(comment.codes) if self.is_unused(index, at, name)]
            everything = len(unused) == len(comment.codes)
            for at in unused:
                delete = comment.line_span if everything else code_removal(comment, at)
                found.append(UnusedSuppression(comment.path, comment.code_spans[at], comment.codes[at], delete))
        return found

    def is_unused(self, index: int, at: int, name: str) -> bool:
        codes = codes_named(name)
        return (index, at) not in self.used and bool(codes) and codes <= self.ran_at(self.comments[index].path)

    def without_reason(self) -> list[ReasonlessIgnore]:
        """Return the comments that give no reason, without those that are unused altogether."""
        found = []
        for index, comment in enumerate(self.comments):
            is_needed = any(
                codes_named(name) and not self.is_unused(index, at, name) for at, name in enumerate(comment.codes)
            )
            if is_needed and not comment.reason:
                found.append(ReasonlessIgnore(comment.path, comment.code_spans[0], ", ".join(comment.codes)))
        return found


def code_removal(comment: Suppression, at: int) -> Span:
    """Return what to delete so that one of several codes is gone, with a comma."""
    spans = comment.code_spans
    if at:
        return Span(spans[at - 1].end, spans[at].end)
    return Span(spans[0].start, spans[1].start)
