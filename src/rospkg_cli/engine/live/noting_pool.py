"""Reads and checks packages of a tree that need not be on disk, and notes what was asked."""

from __future__ import annotations

from collections.abc import Mapping

from ...files import PackageFiles
from ...light_dataclasses import dataclass, field
from ...package.rule_settings import RuleSettings
from ...ros.distros import Targets
from ...tree import Kind, Tree, TreeEntry
from ..reuse.kept_packages import Observed
from ..run.session import Pool, Scope
from ..run.worker import Worker


@dataclass
class NotingTree:
    """A tree that remembers which paths were asked for."""

    tree: Tree
    asked: set[str] = field(default_factory=set)

    def files(self) -> Mapping[str, Kind]:
        return self.tree.files()

    def entry(self, path: str) -> TreeEntry:
        self.asked.add(path)
        return self.tree.entry(path)

    def sub(self, folder: str) -> Tree:
        return self.tree.sub(folder)


@dataclass
class NotingWorker(Worker):
    """A worker whose packages note what lies outside of them, and what they ask the workspace."""

    outside: dict[str, NotingTree] = field(default_factory=dict)

    def files(self, folder: str) -> PackageFiles:
        tree = self.outside.setdefault(folder, NotingTree(self.tree))
        return PackageFiles(self.tree.sub(folder), folder, tree)

    def observed(self) -> dict[str, Observed]:
        return {
            folder: Observed("", {}, dict.fromkeys(self.outside[folder].asked, ("", "", "")), noted)
            for folder, noted in self.questions.items()
        }


class NotingPool(Pool):
    """Runs everything in this process, with a worker that notes."""

    def __init__(self, tree: Tree, scope: Scope, targets: Targets, settings: RuleSettings) -> None:
        self.worker: Worker = NotingWorker(
            tree, scope.folders, targets, settings, scope.name, scope.selected, notes_questions=True
        )
