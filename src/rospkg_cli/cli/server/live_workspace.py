"""One workspace that an editor has open: its packages with the texts that are not saved, linted again and again."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ...config.hierarchy import ConfigTree
from ...disk import DiskTree
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located, locate
from ...engine.fixing.overlay import Overlay
from ...engine.live.live_packages import LivePackages
from ...engine.live.noting_pool import NotingPool
from ...engine.run.session import Results, Session, no_progress
from ...engine.run.worker import Worker
from ...light_dataclasses import dataclass, field, replace
from ...lookup.world import LookupWorld
from ...package.package_facts import PackageFacts
from ...tree import Tree, TreeEntry
from ..lint.lint_options import LintOptions
from ..lint.session import make_session

CHUNK = 12
"""Packages that are linted between two looks at what was typed meanwhile."""


@dataclass
class LiveWorkspace:
    """The packages around a folder that is open in an editor."""

    folder: Path
    texts: dict[Path, bytes] = field(default_factory=dict)
    """What is in the editor, by absolute path, as it would be saved."""
    memory: LivePackages = field(default_factory=LivePackages)
    changed: set[Path] = field(default_factory=set)
    """The paths whose content is not what it was in the last run."""
    wanted: set[Path] = field(default_factory=set)
    """Packages that are linted first."""
    session: Session | None = None
    """Of the last run."""
    root: Path = Path()
    is_finished: bool = False
    """Whether the last run judged all packages."""
    facts: dict[str, PackageFacts] = field(default_factory=dict)
    """The last known facts of each package, by folder."""
    _world: LookupWorld | None = None
    _world_of: Session | None = None
    _world_folders: tuple[str, ...] = ()
    _known: dict[Path, int] = field(default_factory=dict)
    stale: set[Path] = field(default_factory=set)
    """The paths that have changed on disk since something was looked up."""

    def put(self, path: Path, text: bytes | None) -> None:
        """Take the text of an editor for that of a file; None gives the file back."""
        if text is None:
            self.texts.pop(path, None)
        else:
            self.texts[path] = text
        self.changed.add(path)

    def lint(self) -> Results:
        """Lint what is judged already and the next packages; nothing is read of those in which nothing changed.

        Raises UserError for a config that is wrong.
        """
        configs = choose_configs([self.folder])
        located = locate([self.folder], None, configs)
        session = self.prepared(located, configs)
        self.is_finished = session.scope.selected == located.scope.selected
        results = session.run() if located.scope.folders else Results()
        self.facts = {
            each: f for each, f in {**self.facts, **self.memory.facts}.items() if each in session.scope.folders
        }
        self.session, self.root = session, located.root
        return results

    def prepared(self, located: Located, configs: ConfigTree) -> Session:
        """Return the run over what is known already and the next packages."""
        session = make_session(LintOptions(), configs, located, no_progress)
        changed, self.changed = self.changed, set()
        self.stale |= changed
        if located.root != self.root:
            self.memory = LivePackages()
        self.memory.forget(relative_to(changed, located.root), located.scope.folders)
        scope = session.scope
        given = [scope.incomplete, sorted(scope.prefix_names), sorted(map(sorted, scope.repositories)), scope.folders]
        self.memory.require(repr([given, sorted(session.codes), session.settings, session.targets, configs.root]))
        tree = DiskTree(located.root, scope.folders)
        return replace(
            session,
            tree=self.overlay(tree, located.root),
            scope=replace(scope, selected=self.next_packages(located)),
            kept=self.memory,
            make_pool=NotingPool,
            make_small_pool=NotingPool,
        )

    def world(self) -> LookupWorld | None:
        """Return the packages for looking up, with the texts of the editor; None before the first run.

        What was read of packages is kept as long as no text changes.
        """
        session = self.session
        if session is None:
            return None
        known = {path: id(text) for path, text in list(self.texts.items())}
        if self._world is None or session is not self._world_of or known != self._known:
            changed = {path for path in {*known, *self._known} if known.get(path) != self._known.get(path)}
            tree = self.overlay(DiskTree(self.root, session.scope.folders), self.root)
            facts = [*self.facts.values(), *self.facts_of_others(tree)]
            world = LookupWorld(tree, session.link(sorted(facts, key=lambda each: each.folder)))
            if self._world is not None and session.scope.folders == self._world_folders:
                world.keep(
                    self._world, {package_of(path, self.root, session.scope.folders) for path in changed | self.stale}
                )
            self._world, self._world_of, self._known = world, session, known
            self._world_folders, self.stale = session.scope.folders, set()
        return self._world

    def facts_of_others(self, tree: Tree) -> list[PackageFacts]:
        """Return the facts of the packages that no run has read yet, collected as they are asked for."""
        if self.session is None:
            return []
        scope, targets = self.session.scope, self.session.targets
        unread = set(scope.folders) - self.facts.keys()
        return Worker(tree, sorted(unread), targets, name=scope.name, selected=frozenset()).collect_facts(unread)

    def overlay(self, tree: DiskTree, root: Path) -> Overlay:
        """Return a tree below a root with the texts of the editor over it."""
        inside = {path: text for path, text in list(self.texts.items()) if path.is_relative_to(root)}
        texts = {path.relative_to(root).as_posix(): text for path, text in inside.items()}
        return Overlay(tree, {path: with_text(tree, path, text) for path, text in texts.items()})

    def next_packages(self, located: Located) -> frozenset[str]:
        """Return the packages that are judged already, those that are wanted, and some more."""
        scope = located.scope
        known = self.memory.results.keys() & scope.selected
        wanted = {f for f in scope.selected if located.root / f in self.wanted}
        others = sorted(scope.selected - known - wanted)
        return frozenset(known | wanted | set(others[: 0 if wanted - known else CHUNK]))


def with_text(tree: DiskTree, path: str, text: bytes) -> TreeEntry:
    """Return a file with the text of an editor; its mode is that on disk."""
    try:
        return replace(tree.entry(path), data=text, skipped="")
    except OSError:
        return TreeEntry("file", text)


def relative_to(paths: Iterable[Path], root: Path) -> list[str]:
    """Return paths from a root; one outside of it as it is."""
    return [path.relative_to(root).as_posix() if path.is_relative_to(root) else str(path) for path in paths]


def package_of(path: Path, root: Path, folders: Iterable[str]) -> str | None:
    """Return the innermost of some folders (from the root) that holds a path; None where none does."""
    if not path.is_relative_to(root):
        return None
    inner = path.relative_to(root).as_posix() + "/"
    found = [each for each in folders if not each or inner.startswith(f"{each}/")]
    return max(found, key=len, default=None)
