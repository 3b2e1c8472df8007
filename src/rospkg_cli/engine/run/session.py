"""One run over a tree: read, link, check, silence."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from ...files import PackageFiles
from ...finding import Finding
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.run_events import RUN_EVENTS, NoPackagesFound, RuleCrash
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.names import BUILT_IN, Names
from ...rule import Rule
from ...tree import Tree
from ..suppression.suppression_index import SuppressionIndex
from .crashes import one_each
from .finding_builder import FindingBuilder, rule_by_code
from .rule_inputs import InputBuilder
from .run_rules import run_rules
from .worker import PackageResults, Worker


@dataclass(frozen=True)
class Scope:
    """What a run looks at. Folders are relative to the root of the tree."""

    folders: tuple[str, ...]
    """Every package of the workspace."""
    given: frozenset[str]
    """Those to report on."""
    name: str = "package"
    """The name of the root folder."""
    complete: bool = True
    prefix_names: frozenset[str] = frozenset()
    index: Names = BUILT_IN
    """The names of the world outside."""
    repositories: tuple[frozenset[str], ...] = ()
    """The packages of each repository."""


@dataclass(frozen=True)
class Results:
    """What a run found; findings are sorted, and `suppressed` ones are kept apart."""

    findings: tuple[Finding, ...] = ()
    suppressed: tuple[Finding, ...] = ()
    crashes: tuple[RuleCrash, ...] = ()
    packages: int = 0
    files: int = 0


class Pool:
    """Runs everything in this process; `engine.run.pool` has the one that spreads it over several."""

    def __init__(self, tree: Tree, scope: Scope, targets: Targets, settings: RuleSettings) -> None:
        self.worker = Worker(tree, scope.folders, targets, settings, scope.name)

    def collect_facts(self) -> list[PackageFacts]:
        return self.worker.collect_facts()

    def run_rules(self, workspace: Workspace, codes: Sequence[str]) -> list[PackageResults]:
        return self.worker.run_rules(workspace, codes)

    def close(self) -> None:
        """Release what the pool holds."""


def no_progress(_: str) -> None:
    """Keep quiet about progress."""


def keep_all(_: Session, results: Results) -> Results:
    return results


@dataclass
class Session:
    tree: Tree
    scope: Scope
    codes: frozenset[str]
    targets: Targets = field(default_factory=Targets)
    settings: RuleSettings = field(default_factory=RuleSettings)
    make_pool: Callable[[Tree, Scope, Targets, RuleSettings], Pool] = Pool
    judge: Callable[[Session, Results], Results] = keep_all
    """Sets aside what the config or a baseline ignores."""
    phase: Callable[[str], None] = no_progress
    """Is told what the run is at."""

    def run(self) -> Results:
        """Lint everything that is given; never raises for what a package holds."""
        count = f"{len(self.scope.folders)} packages"
        self.phase(f"reading {count}")
        pool = self.make_pool(self.tree, self.scope, self.targets, self.settings)
        try:
            facts = sorted(pool.collect_facts(), key=lambda f: f.folder)
            workspace = self.link(facts)
            self.phase(f"checking {len(self.scope.given)} of {count}")
            checked = pool.run_rules(workspace, sorted(self.codes))
        finally:
            pool.close()
        return self.judge(self, self.collect(workspace, checked))

    def link(self, facts: Sequence[PackageFacts]) -> Workspace:
        scope = self.scope
        around = (scope.given, scope.complete, scope.prefix_names, scope.repositories)
        return Workspace(tuple(facts), *around, scope.index)

    def collect(self, workspace: Workspace, checked: Sequence[PackageResults]) -> Results:
        over_all = list(self.over_all(workspace))
        findings = [f for each in checked for f in each.findings] + [r for r in over_all if isinstance(r, Finding)]
        crashes = [c for each in checked for c in each.crashes] + [r for r in over_all if isinstance(r, RuleCrash)]
        silence = SuppressionIndex([s for each in checked for s in each.suppressions], self.codes)
        judged = silence.apply(findings)
        crashes = one_each(crashes)
        happened: list[Any] = [*silence.unused(), *silence.unknown(), *crashes]
        judged += silence.apply(self.report(workspace, happened))
        judged.sort(key=lambda f: f.sort_key)
        return Results(
            tuple(f for f in judged if f.suppressed is None),
            tuple(f for f in judged if f.suppressed is not None),
            tuple(crashes),
            len(workspace.given),
            sum(each.files for each in checked),
        )

    def over_all(self, workspace: Workspace) -> Iterable[Finding | RuleCrash]:
        rules = [r for r in map(rule_by_code, sorted(self.codes)) if r.over is Workspace]
        return run_rules(Given(workspace), rules, self.stamper(workspace))

    def report(self, workspace: Workspace | None, happened: Sequence[object]) -> list[Finding]:
        """Turn what happened in the run itself into findings, by the RPK rules."""
        rules = [rule_by_code(code) for code in sorted(self.codes | {"RPK005", "RPK006"})]
        stamper = self.stamper(workspace or Workspace())
        return [
            stamper.stamp(rule, hit)
            for rule in rules
            if rule.over in RUN_EVENTS
            for each in happened
            if isinstance(each, rule.over)
            for hit in rule.check(each)
        ]

    def with_crashes(self, results: Results, crashes: Sequence[RuleCrash]) -> Results:
        """Return the results with faults of ours that befell what came after the rules, each once."""
        told = one_each(crashes)
        said = [replace(finding, package=each.package) for each in told for finding in self.report(None, [each])]
        findings = sorted((*results.findings, *said), key=lambda f: f.sort_key)
        return replace(results, findings=tuple(findings), crashes=(*results.crashes, *told))

    def stamper(self, workspace: Workspace) -> FindingBuilder:
        files = PackageFiles(self.tree)
        return RootFindingBuilder(files, files, "", workspace)

    def nothing(self, paths: Sequence[str], hidden: str = "") -> Results:
        """Return the results of a run that found no package."""
        return Results(tuple(self.report(Workspace(), [NoPackagesFound(tuple(paths), hidden)])))


class Given(InputBuilder):
    """The one slice of rules over the whole workspace."""

    def __init__(self, workspace: Workspace) -> None:
        self.provided = {Workspace: workspace}


@dataclass
class RootFindingBuilder(FindingBuilder):
    """Stamps hits whose paths are relative to the root of the run; the package is the one that the path is in."""

    workspace: Workspace

    def stamp(self, rule: Rule[Any], hit: Any) -> Finding:
        self.package = self.workspace.around(hit.path.lstrip("/"))
        return super().stamp(rule, hit)
