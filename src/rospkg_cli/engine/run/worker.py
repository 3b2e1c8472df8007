"""The packages that one process reads and checks; what goes in and comes out is plain values."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cache, partial

from ...disk import DiskTree
from ...disk_trace import current_trace
from ...files import PackageFiles
from ...finding import Finding
from ...light_dataclasses import dataclass, field
from ...package.collect_facts import collect_facts, unknown_facts
from ...package.facts_on_demand import facts_on_demand
from ...package.package import Package
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.run_events import RuleCrash
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...rule_table import rule_by_code
from ...tree import Tree
from ..reuse.kept_packages import Observed
from ..reuse.recorded_facts import Question
from ..reuse.recorded_tree import RecordedTree, listing
from ..reuse.recorded_workspace import RecordedWorkspace
from ..suppression.comments import suppressions_in
from .crashes import reader_crashes
from .finding_builder import FindingBuilder
from .fitting_rules import fitting_rules, is_over_packages
from .lazy_checks import is_left, why_unmet, why_warning
from .milder_behind import milder_behind
from .package_results import PackageResults, checksums_of
from .rule_inputs import InputBuilder
from .run_rules import InputsOf, run_rules
from .unbuilt_package import of_unbuilt

NO_SETTINGS = RuleSettings()

MAX_KEPT = 1_000
"""Packages of a process whose models are kept until they are checked; those of more are read twice, as each package
keeps 30 KiB or more."""


@dataclass
class Worker:
    tree: Tree
    folders: Sequence[str]
    targets: Targets
    settings: RuleSettings = NO_SETTINGS
    name: str = "package"
    """What a package in the root is called when its manifest does not say."""
    selected: frozenset[str] | None = None
    """The packages that are checked, where the facts of the others may be collected as they are asked for."""
    packages: dict[str, Package] = field(default_factory=dict)
    notes_questions: bool = False
    """Whether it notes what packages ask the workspace, where the run is not traced."""
    questions: dict[str, frozenset[Question]] = field(default_factory=dict)
    """What was noted, by folder."""

    def __post_init__(self) -> None:
        self.is_recorded = current_trace() is not None and isinstance(self.tree, DiskTree)
        self.known_questions: dict[Question, Question] = {}
        """Each question once, however many packages ask it."""
        self.checked: dict[str, Observed] = {}
        """What was asked while packages were read and checked, by folder."""
        self.packages = {f: Package(self.files(f)) for f in self.folders}

    def files(self, folder: str) -> PackageFiles:
        """Return the files of a package; where the run is traced, they remember which of them were asked for."""
        if self.is_recorded and isinstance(self.tree, DiskTree):
            return PackageFiles(RecordedTree(self.tree.sub(folder)), folder, RecordedTree(self.tree))
        return PackageFiles(self.tree.sub(folder), folder, self.tree)

    def observed(self) -> dict[str, Observed]:
        """Return what was asked while packages were read and checked, by folder; nothing of those that weren't."""
        for folder, package in self.packages.items():
            self.checked |= observed_in(folder, package)
        return self.checked

    def collect_facts(self, wanted: Collection[str]) -> list[PackageFacts]:
        """Return the facts of the packages of this worker that are wanted."""
        found: list[PackageFacts] = []
        for folder, package in self.packages.items():
            if folder in wanted:
                found.append(self.facts(folder, package))
                if len(found) > MAX_KEPT and not found[-1].is_on_demand:
                    self.packages[folder] = self.unread(folder, package)
        return found

    def unread(self, folder: str, package: Package) -> Package:
        """Return a package of which nothing is read yet, with what is known of another's files and crashes."""
        fresh = Package(self.files(folder))
        fresh.crashes |= package.crashes
        before, now = package.files, fresh.files
        for old, new in ((before.tree, now.tree), (before.whole, now.whole)):
            if isinstance(old, RecordedTree) and isinstance(new, RecordedTree):
                new.reads |= old.reads
        return fresh

    def facts(self, folder: str, package: Package) -> PackageFacts:
        """Return a package's facts; of one that raises an exception, only the folder is known to the others."""
        try:
            on_demand = self.selected is not None and folder not in self.selected
            collect = facts_on_demand if on_demand else collect_facts
            return collect(package, self.targets, folder, self.name)
        except Exception:
            import traceback

            package.crashes["PackageFacts"] = traceback.format_exc()
            return unknown_facts(folder, self.name)

    def run_rules(self, workspace: Workspace, codes: Iterable[str], wanted: Collection[str]) -> list[PackageResults]:
        """Run the rules (without those over the whole workspace) over the wanted packages of this worker."""
        codes = [code for code in codes if is_over_packages(code)]
        return [self.check(folder, workspace, codes) for folder in self.folders if folder in wanted]

    def inputs(self, package: Package, workspace: Workspace) -> InputsOf:
        """Return what gives a rule its inputs of a package."""
        return InputBuilder(package, workspace, self.targets, self.settings).of

    def check(self, folder: str, workspace: Workspace, codes: Iterable[str]) -> PackageResults:
        """Run some rules over one package."""
        package = self.packages.pop(folder)  # what was read of it is given back when it is checked
        view = workspace.seen_from(folder)
        seen = RecordedWorkspace(view, folder) if self.is_recorded or self.notes_questions else view
        whole = PackageFiles(package.files.whole or self.tree)
        facts = workspace.at(folder)
        inputs = self.inputs(package, seen)
        left, warned, unmet = cache(partial(is_left, inputs)), partial(why_warning, inputs), partial(why_unmet, inputs)
        builder = FindingBuilder(package.files, whole, facts.name, left, warned, unmet)
        rules = [rule_by_code(code) for code in fitting_rules(codes, package, facts)]
        results = milder_behind(list(run_rules(inputs, rules, builder)), inputs, folder)
        results = of_unbuilt(results, package.files, folder, facts.name, seen)
        results += reader_crashes(package, builder.package, builder.crash_path)
        findings = tuple(r for r in results if isinstance(r, Finding))
        crashes = tuple(r for r in results if isinstance(r, RuleCrash))
        suppressions = tuple(suppressions_in(package.files))
        changed = {o.path for f in findings if f.fix for o in f.fix.operations} | {s.path for s in suppressions}
        checksums = tuple(checksums_of(package.files, changed))
        if isinstance(seen, RecordedWorkspace):
            noted = frozenset(self.known_questions.setdefault(each, each) for each in seen.noted)
            self.questions[folder] = noted
            self.checked |= observed_in(folder, package, noted)
        return PackageResults(folder, findings, crashes, suppressions, len(package.files.paths), checksums)


def observed_in(folder: str, package: Package, noted: frozenset[Question] = frozenset()) -> dict[str, Observed]:
    """Return what was asked of a package's files, by its folder; nothing where none was, or a reader crashed."""
    own, whole = package.files.tree, package.files.whole
    if not isinstance(own, RecordedTree) or not isinstance(whole, RecordedTree) or not own.reads or package.crashes:
        return {}
    return {folder: Observed(listing(own), own.reads, whole.reads, noted)}
