"""Reads and checks packages of a tree that need not be on disk, notes what was asked, and may be interrupted."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from types import MappingProxyType

from ...files import PackageFiles
from ...light_dataclasses import dataclass, field
from ...package.collect_facts import is_unknown
from ...package.package import Package
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...tree import Kind, Tree, TreeEntry
from ..reuse.kept_packages import Observed
from ..run.package_memory import to_be_kept
from ..run.package_results import PackageResults
from ..run.pool import Pool
from ..run.run_rules import InputsOf
from ..run.scope import Scope
from ..run.worker import Worker
from .live_packages import LivePackages
from .safe_point import RunInterrupted, never

NONE_TYPED: Mapping[str, PackageFacts] = MappingProxyType({})


@dataclass
class NotingTree:
    """A tree that remembers which paths were asked for; a run may be interrupted at each of them."""

    tree: Tree
    look: Callable[[], None] = never
    asked: set[str] = field(default_factory=set)

    def files(self) -> Mapping[str, Kind]:
        return self.tree.files()

    def entry(self, path: str) -> TreeEntry:
        self.look()
        self.asked.add(path)
        return self.tree.entry(path)

    def sub(self, folder: str) -> Tree:
        return self.tree.sub(folder)


@dataclass
class NotingWorker(Worker):
    """A worker whose packages note what lies outside of them, and what they ask the workspace."""

    outside: dict[str, NotingTree] = field(default_factory=dict)
    look: Callable[[], None] = never

    def files(self, folder: str) -> PackageFiles:
        tree = self.outside.setdefault(folder, NotingTree(self.tree, self.look))
        return PackageFiles(NotingTree(self.tree.sub(folder), self.look), folder, tree)

    def inputs(self, package: Package, workspace: Workspace) -> InputsOf:
        """Return what gives a rule its inputs, at a safe point before each rule."""
        inputs_of = super().inputs(package, workspace)

        def looking(kind: type) -> list[object]:
            self.look()
            return inputs_of(kind)

        return looking

    def observed(self) -> dict[str, Observed]:
        return {
            folder: Observed("", {}, dict.fromkeys(self.outside[folder].asked, ("", "", "")), noted)
            for folder, noted in self.questions.items()
        }


class NotingPool(Pool):
    """Runs everything in this process, with a worker that notes; `memory` gets what an interrupted run has found.

    `typed` has the last facts of the packages, by folder, whose manifest is being typed.
    """

    def __init__(
        self,
        tree: Tree,
        scope: Scope,
        targets: Targets,
        settings: RuleSettings,
        look: Callable[[], None] = never,
        memory: LivePackages | None = None,
        typed: Mapping[str, PackageFacts] = NONE_TYPED,
    ) -> None:
        self.memory, self.typed = memory, typed
        self.worker: Worker = NotingWorker(
            tree, scope.folders, targets, settings, scope.name, scope.selected, notes_questions=True, look=look
        )

    def collect_facts(self, wanted: Collection[str]) -> list[PackageFacts]:
        """Return facts; of a package whose manifest can't be read between two keys, what was known before."""
        found = self.worker.collect_facts(wanted)
        return [self.typed.get(each.folder, each) if is_unknown(each) else each for each in found]

    def run_rules(self, workspace: Workspace, codes: Sequence[str], wanted: Collection[str]) -> list[PackageResults]:
        """Run the rules package by package; those that were checked before an interruption need not be again."""
        found: list[PackageResults] = []
        try:
            for folder in sorted(wanted):
                found += self.worker.run_rules(workspace, codes, [folder])
        except RunInterrupted:
            self.keep(workspace, found)
            raise
        return found

    def keep(self, workspace: Workspace, found: Sequence[PackageResults]) -> None:
        """Keep what was found in some packages, and nothing that was read of the others."""
        good = {each.folder: to_be_kept(each) for each in found if not each.crashes}
        others = frozenset(each.folder for each in workspace.packages) - good.keys()
        if self.memory is not None:
            self.memory.keep(workspace, self.observed(), good, others)
