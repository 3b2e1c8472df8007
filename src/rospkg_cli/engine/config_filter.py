"""Apply the user's config to findings: those that it ignores are set aside, severities are changed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from fnmatch import fnmatch
from functools import cached_property
from pathlib import Path

from ..config.file import Config, Ignores, Keys, OverrideSection
from ..config.hierarchy import ConfigTree
from ..finding import Finding, Severity
from ..light_dataclasses import dataclass, field, replace
from ..package.run_events import UnknownRuleName, UnusedSuppression
from .discovery.exclusions import Exclusions
from .run.codes_of_packages import enclosing_folder
from .run.results import Results
from .run.scope import Scope
from .run.session import Session
from .selection import codes_named


@dataclass(frozen=True)
class ConfigFilter:
    """Applies the ignores and the severities of the configs to the results of a run, each to its own packages."""

    configs: ConfigTree
    root: Path
    """The root of the run: paths of findings are relative to it."""
    scope: Scope
    exclusions: Exclusions
    used: set[tuple[Path | None, Keys]] = field(default_factory=set)
    """The ignores that set something aside: the config, and the keys that lead to them."""

    def __call__(self, session: Session, results: Results) -> Results:
        """Return the results with the ignores and severities applied, and findings on the configs themselves."""
        filtered = [self.apply(finding) for finding in results.findings]
        kept = [f for f in filtered if f.suppressed is None]
        events = [event for config, own in self.present for event in self.config_events(config, own, session)]
        extra = session.report(None, events)
        return replace(
            results,
            findings=tuple(sorted((*kept, *extra), key=lambda f: f.sort_key) if extra else kept),
            suppressed=(*results.suppressed, *(f for f in filtered if f.suppressed is not None)),
        )

    @cached_property
    def folders(self) -> frozenset[str]:
        """The folders of all packages."""
        return frozenset(self.scope.folders)

    def config_of(self, path: str) -> Config:
        """Return the config that holds for a path of the run: that of the package around it, else the root's."""
        folder = enclosing_folder(path, self.folders)
        return self.configs.root if folder is None else self.configs.at(self.root / folder)

    @cached_property
    def present(self) -> list[tuple[Config, list[str]]]:
        """The root's config and those of the packages, each with the folders of its packages."""
        found: dict[Path | None, tuple[Config, list[str]]] = {self.configs.root.path: (self.configs.root, [])}
        for folder in self.scope.folders:
            config = self.configs.at(self.root / folder)
            found.setdefault(config.path, (config, []))[1].append(folder)
        return list(found.values())

    def apply(self, finding: Finding) -> Finding:
        """Return the finding with its severity by the config, suppressed where the config ignores it."""
        config = self.config_of(finding.location.path)
        sections = list(self.sections(config, finding))
        tables: list[tuple[Keys, Ignores]] = [(("ignore",), config.ignore)]
        tables += [((s.key, s.pattern, "ignore"), s.ignore) for s in sections]
        for keys, ignores in tables:
            name = longest_match(ignores, finding.code)
            if name is not None:
                self.used.add((config.path, (*keys, name)))
                return replace(finding, suppressed=ignores[name], external=True)
        levels = [level for s in sections if (level := configured_level(s.severity, finding.code))]
        level = levels[-1] if levels else configured_level(config.severity, finding.code)
        if level == "off":
            return replace(finding, suppressed="severity is off in the config", external=True)
        return replace(finding, severity=Severity(level)) if level else finding

    def config_events(
        self, config: Config, own: list[str], session: Session
    ) -> Iterator[UnknownRuleName | UnusedSuppression]:
        """Yield the unknown rule names in a config and, after a run over all its packages, what it has unused."""
        path = config.path
        is_whole = self.scope.selected.issuperset(self.scope.folders if config is self.configs.root else own)
        if path is None or not path.is_relative_to(self.root):
            return
        from .suppression.config_rule_names import first_occurrence, rule_name_events

        below = path.relative_to(self.root).as_posix()
        with suppress(OSError, UnicodeError):
            text = session.tree.entry(below).text.text
            used = {keys for of, keys in self.used if of == path}
            ran = frozenset[str]().union(*(session.codes_at(folder) for folder in own)) if own else session.codes
            yield from rule_name_events(config, below, text, used, ran if is_whole else frozenset())
            for pattern in self.exclusions.unused(config) if is_whole else ():
                if span := first_occurrence(text, pattern):
                    yield UnusedSuppression(below, span, pattern, None, is_pattern=True)

    def sections(self, config: Config, finding: Finding) -> Iterable[OverrideSection]:
        """Yield the sections whose pattern fits the finding's package, or its path below the config's folder."""
        yield from (s for s in config.per_package if fnmatch(finding.package, s.pattern))
        if not config.per_path:
            return
        path = self.root / finding.location.path
        if path.is_relative_to(config.folder):
            below = path.relative_to(config.folder).as_posix()
            yield from (s for s in config.per_path if matches_path(below, s.pattern))


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
