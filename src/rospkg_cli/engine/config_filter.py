"""Apply the user's config to findings: those that it ignores are set aside, severities are changed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from fnmatch import fnmatch
from pathlib import Path

from ..config.file import Config, Ignores, Keys, OverrideSection
from ..finding import Finding, Severity
from ..light_dataclasses import dataclass, field, replace
from ..package.run_events import UnknownRuleName, UnusedSuppression
from .run.session import Results, Session
from .selection import codes_named


@dataclass(frozen=True)
class ConfigFilter:
    """Applies the ignores and the severities of a config to the results of a run."""

    config: Config
    root: Path
    """The root of the run: paths of findings are relative to it."""
    whole: bool = True
    """Whether the run looks at every package, so that an ignore without a finding is reported as unused."""
    used: set[Keys] = field(default_factory=set)
    """The ignores that set something aside, as the keys that lead to them."""

    def __call__(self, session: Session, results: Results) -> Results:
        """Return the results with the config's ignores and severities applied, and findings on the config itself."""
        filtered = [self.apply(finding) for finding in results.findings]
        kept = [f for f in filtered if f.suppressed is None]
        extra = session.report(None, list(self.config_events(session)))
        return replace(
            results,
            findings=tuple(sorted((*kept, *extra), key=lambda f: f.sort_key) if extra else kept),
            suppressed=(*results.suppressed, *(f for f in filtered if f.suppressed is not None)),
        )

    def apply(self, finding: Finding) -> Finding:
        """Return the finding with its severity by the config, suppressed where the config ignores it."""
        sections = list(self.sections(finding))
        tables: list[tuple[Keys, Ignores]] = [(("ignore",), self.config.ignore)]
        tables += [((s.key, s.pattern, "ignore"), s.ignore) for s in sections]
        for keys, ignores in tables:
            name = longest_match(ignores, finding.code)
            if name is not None:
                self.used.add((*keys, name))
                return replace(finding, suppressed=ignores[name], external=True)
        levels = [level for s in sections if (level := configured_level(s.severity, finding.code))]
        level = levels[-1] if levels else configured_level(self.config.severity, finding.code)
        if level == "off":
            return replace(finding, suppressed="severity is off in the config", external=True)
        return replace(finding, severity=Severity(level)) if level else finding

    def config_events(self, session: Session) -> Iterator[UnknownRuleName | UnusedSuppression]:
        """Yield the unknown rule names in the config and, after a run over all packages, its unused ignores."""
        path = self.config.path
        if path is not None and path.is_relative_to(self.root):
            from .suppression.config_rule_names import rule_name_events

            below = path.relative_to(self.root).as_posix()
            with suppress(OSError, UnicodeError):
                text = session.tree.entry(below).text.text
                yield from rule_name_events(
                    self.config, below, text, self.used, session.codes if self.whole else frozenset()
                )

    def sections(self, finding: Finding) -> Iterable[OverrideSection]:
        """Yield the sections whose pattern fits the finding's package, or its path below the config's folder."""
        yield from (s for s in self.config.per_package if fnmatch(finding.package, s.pattern))
        if not self.config.per_path:
            return
        path = self.root / finding.location.path
        if path.is_relative_to(self.config.folder):
            below = path.relative_to(self.config.folder).as_posix()
            yield from (s for s in self.config.per_path if matches_path(below, s.pattern))


def matches_path(path: str, pattern: str) -> bool:
    """Return whether a pattern fits a path or a folder above it."""
    parts = path.split("/")
    return any(fnmatch("/".join(parts[:n]), pattern.rstrip("/")) for n in range(1, len(parts) + 1))


def longest_match(table: Mapping[str, str], code: str) -> str | None:
    """Return the longest of the codes, names and prefixes in a table that matches a code."""
    return max((name for name in table if code in codes_named(name)), key=len, default=None)


def configured_level(table: Mapping[str, str], code: str) -> str | None:
    name = longest_match(table, code)
    return None if name is None else table[name]
