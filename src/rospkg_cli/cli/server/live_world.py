"""The packages of one workspace for looking up, as an editor has them; all here goes on in the thread of lookups."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from queue import Empty, SimpleQueue

from ...disk import DiskTree
from ...engine.run.worker import Worker
from ...light_dataclasses import dataclass, field
from ...lookup.world import LookupWorld
from ...package.package_facts import PackageFacts
from ...tree import Tree
from .live_lint import Scene
from .open_text import OpenText
from .text_overlay import overlay, package_of


@dataclass
class LiveWorld:
    """Remembers what was read of packages until one of their texts changes."""

    written: SimpleQueue[Path] = field(default_factory=SimpleQueue)
    """Paths that have changed on disk: any thread may put one."""
    _world: LookupWorld | None = None
    _scene: Scene | None = None
    _texts: Mapping[Path, OpenText] = field(default_factory=dict)

    def at(self, scene: Scene, texts: Mapping[Path, OpenText]) -> LookupWorld:
        """Return the packages that a run found, with the texts that are in the editor now."""
        before = self._texts
        changed = {path for path in {*texts, *before} if texts.get(path) is not before.get(path)} | self.drained()
        if self._world is None or scene is not self._scene or changed:
            folders = scene.session.scope.folders
            tree = overlay(DiskTree(scene.root, folders), scene.root, texts)
            facts = [*scene.facts.values(), *facts_of_others(scene, tree)]
            world = LookupWorld(tree, scene.session.link(sorted(facts, key=lambda each: each.folder)))
            if self._world and self._scene and folders == self._scene.session.scope.folders:
                world.keep(self._world, {package_of(path, scene.root, folders) for path in changed})
            self._world, self._scene, self._texts = world, scene, texts
        return self._world

    def drained(self) -> set[Path]:
        found = set()
        while True:
            try:
                found.add(self.written.get_nowait())
            except Empty:
                return found


def facts_of_others(scene: Scene, tree: Tree) -> list[PackageFacts]:
    """Return the facts of the packages that no run has read yet, collected as they are asked for."""
    scope, targets = scene.session.scope, scene.session.targets
    unread = set(scope.folders) - scene.facts.keys()
    return Worker(tree, sorted(unread), targets, name=scope.name, selected=frozenset()).collect_facts(unread)
