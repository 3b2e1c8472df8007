"""What the user's config makes of findings: ignored with a reason, milder, stronger, or off."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fnmatch import fnmatch
from pathlib import Path

from ..config import Config, Section
from ..finding import Finding, Severity
from ..model.happenings import UnknownRuleName, UnusedSuppression
from ..source import Span
from ..suggest import nearest
from .selection import codes_named, rule_names
from .session import Results


@dataclass(frozen=True)
class Judge:
    config: Config
    root: Path
    """Of the run; the paths of findings are relative to it."""
    used: set[str] = field(default_factory=set)
    """The names in `ignore` that set something aside."""

    def __call__(self, results: Results) -> Results:
        """Return the results with the config's ignores and severities applied."""
        judged = [self.judge(finding) for finding in results.findings]
        return replace(
            results,
            findings=tuple(f for f in judged if f.suppressed is None),
            suppressed=(*results.suppressed, *(f for f in judged if f.suppressed is not None)),
        )

    def judge(self, finding: Finding) -> Finding:
        sections = list(self.sections(finding))
        for ignores in [self.config.ignore, *(s.ignore for s in sections)]:
            name = longest(ignores, finding.code)
            if name is not None:
                self.used.add(name)
                return replace(finding, suppressed=ignores[name])
        levels = [level for s in sections if (level := said(s.severity, finding.code))]
        level = levels[-1] if levels else said(self.config.severity, finding.code)
        if level == "off":
            return replace(finding, suppressed="severity is off in the config")
        return replace(finding, severity=Severity(level)) if level else finding

    def happenings(self, ran: frozenset[str], whole: bool) -> Iterator[UnknownRuleName | UnusedSuppression]:
        """Yield what is wrong with the rule names of the config; needless ignores only after a `whole` run."""
        path = self.config.path
        if path is None or not path.is_relative_to(self.root):
            return
        text, below = path.read_text("utf-8", "replace"), path.relative_to(self.root).as_posix()
        for name in dict.fromkeys(self.names()):
            at = text.find(name)
            span = Span(at, at + len(name)) if at >= 0 else Span(0, 0)
            codes = codes_named(name)
            if not codes:
                yield UnknownRuleName(below, span, name, nearest(name, rule_names()))
            elif whole and name in self.config.ignore and name not in self.used and codes <= ran:
                yield UnusedSuppression(below, span, name, None)

    def names(self) -> list[str]:
        """Return every rule name in the config."""
        sections = (*self.config.per_package, *self.config.per_path)
        tables = [self.config.ignore, self.config.severity]
        tables += [table for section in sections for table in (section.ignore, section.severity)]
        return [*self.config.select, *self.config.extend_select, *(name for table in tables for name in table)]

    def sections(self, finding: Finding) -> Iterable[Section]:
        """Yield the sections whose pattern fits the finding's package, or its path below the config's folder."""
        yield from (s for s in self.config.per_package if fnmatch(finding.package, s.pattern))
        path = self.root / finding.place.path
        if path.is_relative_to(self.config.folder):
            below = path.relative_to(self.config.folder).as_posix()
            yield from (s for s in self.config.per_path if fits(below, s.pattern))


def fits(path: str, pattern: str) -> bool:
    """Return whether a pattern fits a path or a folder above it."""
    parts = path.split("/")
    return any(fnmatch("/".join(parts[:n]), pattern.rstrip("/")) for n in range(1, len(parts) + 1))


def longest(table: Mapping[str, str], code: str) -> str | None:
    """Return the longest of the codes, names and prefixes in a table that stands for a code."""
    return max((name for name in table if code in codes_named(name)), key=len, default=None)


def said(table: Mapping[str, str], code: str) -> str | None:
    name = longest(table, code)
    return None if name is None else table[name]
