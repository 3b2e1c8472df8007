"""One run over a tree: read, link, check, suppress."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import partial
from typing import Any

from ...files import PackageFiles
from ...finding import Finding
from ...light_dataclasses import dataclass, field, replace
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.run_events import NoPackagesFound, RuleCrash
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...rule_table import rule_by_code, rule_entries
from ...tree import Tree
from ..suppression.suppression_index import SuppressionIndex
from .codes_of_packages import CodesOfPackages
from .crashes import one_each
from .finding_builder import FindingBuilder, RootFindingBuilder, nothing_is_left, nothing_is_seldom
from .package_memory import PackageMemory, kept_results, to_be_kept
from .package_results import PackageResults
from .plugins_left import why_left
from .pool import SERIAL_BELOW, Pool
from .results import Results
from .run_rules import run_rules
from .scope import Scope
from .switched_off import switched_off

ALWAYS = frozenset({"RPK005", "RPK006"})
"""The rules on a run that failed, which no choice leaves out."""


def no_progress(_: str) -> None:
    """Show no progress."""


def keep_all(_: Session, results: Results) -> Results:
    """Return all results, where neither a config nor a baseline sets some aside."""
    return results


@dataclass(frozen=True)
class Session:
    """Everything that a run needs."""

    tree: Tree
    scope: Scope
    codes: frozenset[str]
    targets: Targets = field(default_factory=Targets)
    settings: RuleSettings = field(default_factory=RuleSettings)
    make_pool: Callable[[Tree, Scope, Targets, RuleSettings], Pool] = Pool
    filter_results: Callable[[Session, Results], Results] = keep_all
    """Sets aside what the config or a baseline ignores."""
    show_progress: Callable[[str], None] = no_progress
    """Called with a line for the user at the start of each phase."""
    codes_by_package: CodesOfPackages | None = None
    """Which of the rules run on which package, where not all run on all."""
    reports_switched_off: bool = False
    """Whether it says which checks something around the packages switches off."""

    kept: PackageMemory | None = None
    """What is known from earlier runs; None where nothing of them is to be used."""
    make_small_pool: Callable[[Tree, Scope, Targets, RuleSettings], Pool] = Pool
    """The pool where little is left to be done."""

    def codes_at(self, path: str) -> frozenset[str]:
        """Return the codes of the rules that run on the package around a path of the run, or in that folder."""
        return self.codes if self.codes_by_package is None else self.codes_by_package.at(path)

    def run(self) -> Results:
        """Lint the given packages; never raises for what a package holds."""
        count = f"{len(self.scope.folders)} packages"
        self.show_progress(f"reading {count}")
        known = self.kept.known_facts(self.scope.folders) if self.kept else {}
        unknown = frozenset(self.scope.folders) - known.keys()
        pool = self.pool_for(unknown | (self.kept.unchecked() & self.scope.selected) if self.kept else unknown)
        try:
            facts = sorted([*known.values(), *pool.collect_facts(unknown)], key=lambda f: f.folder)
            workspace = self.link(facts)
            self.show_progress(f"checking {len(self.scope.selected)} of {count}")
            checked = self.check(pool, workspace)
        finally:
            pool.close()
        return self.filter_results(self, self.collect(workspace, checked))

    def pool_for(self, folders: Collection[str]) -> Pool:
        """Return the pool for what is to be done: this process alone where little is left."""
        is_large = self.kept is None or len(folders) >= SERIAL_BELOW
        make = self.make_pool if is_large else self.make_small_pool
        return make(self.tree, self.scope, self.targets, self.settings)

    def check(self, pool: Pool, workspace: Workspace) -> list[PackageResults]:
        """Return what the rules find in the selected packages; what is kept and still holds is not looked for."""
        folders = sorted(self.scope.selected)
        if self.kept is None:
            return pool.run_rules(workspace, sorted(self.codes), self.scope.selected)
        kept = self.kept.known_results(workspace, folders)
        known = {folder: kept_results(folder, *each) for folder, each in kept.items()}
        checked = pool.run_rules(workspace, sorted(self.codes), self.scope.selected - known.keys())
        observed, failed = pool.observed(), frozenset(each.folder for each in checked if each.crashes)
        self.kept.keep(workspace, observed, {each.folder: to_be_kept(each) for each in checked}, failed)
        return sorted([*known.values(), *checked], key=lambda each: each.folder)

    def link(self, facts: Sequence[PackageFacts]) -> Workspace:
        scope = self.scope
        around = (scope.selected, not scope.incomplete, scope.prefix_names, scope.repositories)
        missing = (scope.incomplete, scope.missing_repositories)
        return Workspace(tuple(facts), *around, scope.index, *missing, cmake_projects=scope.cmake_projects)

    def collect(self, workspace: Workspace, checked: Sequence[PackageResults]) -> Results:
        of_workspace = list(self.run_workspace_rules(workspace))
        findings = [f for each in checked for f in each.findings] + [r for r in of_workspace if isinstance(r, Finding)]
        crashes = [c for each in checked for c in each.crashes] + [r for r in of_workspace if isinstance(r, RuleCrash)]
        index = SuppressionIndex([s for each in checked for s in each.suppressions], self.codes_at)
        findings = index.apply(self.asked_for(findings))
        crashes = one_each(crashes)
        events: list[Any] = [*index.unused(), *index.unknown(), *index.without_reason(), *crashes]
        events += switched_off(workspace, findings) if self.reports_switched_off else ()
        findings += index.apply(self.report(workspace, events))
        findings.sort(key=lambda f: f.sort_key)
        return Results(
            tuple(f for f in findings if f.suppressed is None),
            tuple(f for f in findings if f.suppressed is not None),
            tuple(crashes),
            len(workspace.selected),
            sum(each.files for each in checked),
            dict(entry for each in checked for entry in each.checksums),
        )

    def run_workspace_rules(self, workspace: Workspace) -> Iterable[Finding | RuleCrash]:
        over_workspace = (code for code in sorted(self.codes) if rule_entries()[code].over == Workspace.__name__)
        rules = [rule_by_code(code) for code in over_workspace]
        return run_rules(lambda _: [workspace], rules, self.finding_builder(workspace))

    def report(self, workspace: Workspace | None, events: Sequence[object]) -> list[Finding]:
        """Turn events of the run itself (a crash, an unused ignore) into findings, by the RPK rules."""
        made, codes = {type(each).__name__ for each in events}, sorted(self.codes | ALWAYS)
        rules = [rule_by_code(code) for code in codes if rule_entries()[code].over in made]
        builder = self.finding_builder(workspace or Workspace())
        found = [
            builder.build(rule, hit)
            for rule in rules
            for each in events
            if isinstance(each, rule.over)
            for hit in rule.check(each)
        ]
        return self.asked_for(found)

    def asked_for(self, findings: list[Finding]) -> list[Finding]:
        """Return the findings of the rules that run on their packages, and those of a run that failed."""
        if self.codes_by_package is None:
            return findings
        return [f for f in findings if f.code in ALWAYS or f.code in self.codes_at(f.location.path)]

    def with_crashes(self, results: Results, crashes: Sequence[RuleCrash]) -> Results:
        """Return the results with crashes of what came after the rules (fixes, say), each cause once."""
        causes = one_each(crashes)
        new = [replace(finding, package=each.package) for each in causes for finding in self.report(None, [each])]
        findings = sorted((*results.findings, *new), key=lambda f: f.sort_key)
        return replace(results, findings=tuple(findings), crashes=(*results.crashes, *causes))

    def finding_builder(self, workspace: Workspace) -> FindingBuilder:
        files = PackageFiles(self.tree)
        unmet = partial(why_left, files)
        return RootFindingBuilder(files, files, "", nothing_is_left, nothing_is_seldom, unmet, workspace)

    def no_packages(self, paths: Sequence[str], hidden: str = "", place: str = ".") -> Results:
        """Return the results of a run that found no package; `place` leads from its root to the first of the paths."""
        return Results(tuple(self.report(Workspace(), [NoPackagesFound(tuple(paths), hidden, place)])))
