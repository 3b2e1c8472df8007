"""The packages that one process reads and checks; what goes in and comes out is plain values."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cache, partial
from zlib import crc32

from ...disk import DiskTree
from ...disk_trace import current_trace
from ...files import PackageFiles
from ...finding import Finding, Hit, Severity
from ...light_dataclasses import dataclass, field
from ...package.collect_facts import collect_facts, unknown_facts
from ...package.facts_on_demand import facts_on_demand
from ...package.package import Package
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.run_events import RUN_EVENTS, RuleCrash
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...rule_table import rule_by_code, rule_entries
from ...tree import Tree
from ..reuse.kept_packages import Observed
from ..reuse.recorded_tree import RecordedTree, listing
from ..reuse.recorded_workspace import Question, RecordedWorkspace
from ..suppression.comments import Suppression, suppressions_in
from .crashes import reader_crashes
from .finding_builder import OF_STARTS, FindingBuilder
from .milder_behind import milder_behind
from .rule_inputs import InputBuilder
from .run_rules import InputsOf, run_rules
from .unbuilt_package import of_unbuilt

NO_SETTINGS = RuleSettings()

MAX_KEPT = 1_000
"""Packages of a process whose models are kept until they are checked; those of more are read twice, as each package
keeps 30 KiB or more."""


@dataclass(frozen=True)
class PackageResults:
    """What the rules found in one package."""

    folder: str
    findings: tuple[Finding, ...] = ()
    crashes: tuple[RuleCrash, ...] = ()
    suppressions: tuple[Suppression, ...] = ()
    files: int = 0
    checksums: tuple[tuple[str, int], ...] = ()
    """Of the files that fixes change, as they were read here; paths from the root of the run."""


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
        fitting = (code for code in codes if not (facts.is_for_ros1 and code.startswith(OF_ROS_2)))
        rules = [rule_by_code(code) for code in fitting if has_inputs(code, package)]
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


def is_left(inputs: InputsOf, path: str) -> bool:
    """Return whether nothing of a package leads to a file; imported where a finding needs it."""
    from ...checks.left_files import LeftFiles

    return any(each.has(path) for each in inputs(LeftFiles))


def why_warning(inputs: InputsOf, hit: Hit) -> str:
    """Return why a fault that ends a run is met by some alone; imported where a finding needs it."""
    from ...checks.reached_places import ReachedPlaces
    from ...checks.unstarted_programs import UNSTARTED, UnstartedPrograms

    if any(each.has(hit.path) for each in inputs(UnstartedPrograms)):
        return UNSTARTED
    return next((each.why_milder(hit.path, hit.span) for each in inputs(ReachedPlaces)), "")


def why_unmet(inputs: InputsOf, code: str, level: Severity, hit: Hit) -> str:
    """Return why no plain launch or start comes to a hit; imported where a finding needs it."""
    if code in OF_STARTS and hit.path.endswith(".py"):
        from ...checks.unintended_starts import UnintendedStarts

        if why := next((each.why(hit.path, hit.span) for each in inputs(UnintendedStarts)), ""):
            return why
    if not code.startswith(OF_LAUNCHES) or code in ASKING or "launch" not in hit.path:
        return ""
    from ...checks.launch.unmet_places import UnmetPlaces
    from .met_in_launch import why_unmet

    return next((why_unmet(each, code, level, hit) for each in inputs(UnmetPlaces)), "")


def observed_in(folder: str, package: Package, noted: frozenset[Question] = frozenset()) -> dict[str, Observed]:
    """Return what was asked of a package's files, by its folder; nothing where none was, or a reader crashed."""
    own, whole = package.files.tree, package.files.whole
    if not isinstance(own, RecordedTree) or not isinstance(whole, RecordedTree) or not own.reads or package.crashes:
        return {}
    return {folder: Observed(listing(own), own.reads, whole.reads, noted)}


def checksums_of(files: PackageFiles, paths: Iterable[str]) -> Iterator[tuple[str, int]]:
    """Yield each of some files (paths from the root of the run) that is there, with the checksum of its bytes."""
    prefix = files.folder + "/" if files.folder else ""
    for path in sorted(paths):
        with suppress(OSError):
            yield path, crc32(files.tree.entry(path.removeprefix(prefix)).data)


OF_ROS_2 = ("CMK", "DEP", "IDL", "LCH", "PLG", "PRM", "SET", "URD")
"""Families about builds, launches and runs of ROS 2, which a package for ROS 1 has none of."""

OF_LAUNCHES = ("DEP", "LCH", "PRM")
"""Families that tell of launch files."""
ASKING = frozenset({"LCH003", "LCH004"})
"""Rules that ask themselves whether a launch comes to a place, by how it opens the file that is named there."""

OVER_RUNS = {kind.__name__ for kind in RUN_EVENTS | {Workspace}}


def is_over_packages(code: str) -> bool:
    """Return whether a rule is about one package; one that no table knows is."""
    entry = rule_entries().get(code)
    return entry is None or entry.over not in OVER_RUNS


def has_inputs(code: str, package: Package) -> bool:
    """Return whether a package may have what a rule is about: only then it is worth its import."""
    entry = rule_entries().get(code)
    return entry is None or all(package.has(model) for model in entry.needs)
