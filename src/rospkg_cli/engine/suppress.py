"""Set findings aside that a comment or the config silences, and say which silences were needless."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from ..finding import Finding
from ..model.happenings import UnknownRuleName, UnusedSuppression
from ..source import Span
from ..suggest import nearest
from .comments import Suppression
from .selection import codes_named, rule_names


@dataclass
class Silence:
    """All ignore comments of a run; `ran` are the codes of the rules that ran."""

    comments: Sequence[Suppression]
    ran: frozenset[str]
    used: set[tuple[int, int]] = field(default_factory=set)
    """Which code of which comment silenced something."""

    def __post_init__(self) -> None:
        self.by_path: dict[str, list[int]] = defaultdict(list)
        for index, comment in enumerate(self.comments):
            self.by_path[comment.path].append(index)

    def apply(self, findings: Iterable[Finding]) -> list[Finding]:
        """Return the findings, those that are silenced with the reason."""
        return [self.judge(finding) for finding in findings]

    def judge(self, finding: Finding) -> Finding:
        for index in self.by_path.get(finding.place.path, ()):
            comment = self.comments[index]
            if comment.lines and finding.place.line not in comment.lines:
                continue
            for at, name in enumerate(comment.codes):
                if finding.code in codes_named(name):
                    self.used.add((index, at))
                    return replace(finding, suppressed=comment.reason or "no reason given")
        return finding

    def unknown(self) -> list[UnknownRuleName]:
        """Return the names in comments that name no rule."""
        return [
            UnknownRuleName(comment.path, span, name, nearest(name, rule_names()))
            for comment in self.comments
            for name, span in zip(comment.codes, comment.code_spans, strict=True)
            if not codes_named(name)
        ]

    def unused(self) -> list[UnusedSuppression]:
        """Return the codes in comments that silenced nothing although all of their rules ran."""
        found = []
        for index, comment in enumerate(self.comments):
            idle = [at for at, name in enumerate(comment.codes) if self.is_idle(index, at, name)]
            everything = len(idle) == len(comment.codes)
            for at in idle:
                delete = comment.line_span if everything else code_removal(comment, at)
                found.append(UnusedSuppression(comment.path, comment.code_spans[at], comment.codes[at], delete))
        return found

    def is_idle(self, index: int, at: int, name: str) -> bool:
        codes = codes_named(name)
        return (index, at) not in self.used and bool(codes) and codes <= self.ran


def code_removal(comment: Suppression, at: int) -> Span:
    """Return what to delete so that one of several codes is gone, with the comma beside it."""
    spans = comment.code_spans
    if at:
        return Span(spans[at - 1].end, spans[at].end)
    return Span(spans[0].start, spans[1].start)
