"""Lint of one workspace again and again, with the texts of an editor; all here is in the thread of the runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path

from ...config.hierarchy import ConfigTree
from ...disk import DiskTree
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located, locate
from ...engine.live.live_packages import LivePackages
from ...engine.live.noting_pool import NotingPool
from ...engine.live.safe_point import SafePoint
from ...engine.run.results import Results
from ...engine.run.scope import Scope
from ...engine.run.session import Session, no_progress
from ...light_dataclasses import dataclass, field, replace
from ...package.package_facts import PackageFacts
from ..lint.lint_options import LintOptions
from ..lint.session import make_session
from .disk_stamps import DiskStamps
from .open_text import OpenText
from .text_overlay import overlay

CHUNK = 12
"""Packages that are linted between two looks at what was typed meanwhile."""


@dataclass(frozen=True)
class LintOrder:
    """What a run is to see."""

    texts: Mapping[Path, OpenText]
    changed: frozenset[Path]
    """The paths whose content is not what it was in the last run."""
    wanted: frozenset[Path]
    """Packages that are linted first."""
    look: SafePoint = field(default_factory=SafePoint)
    """Where the run, and what is made of it later, may be interrupted."""
    on_disk: Callable[[Path], object] | None = None
    """Called with each file that has changed on disk, where the editor does not report that; None where it does."""


@dataclass(frozen=True)
class Scene:
    """The packages around an editor's files, as a run found them; `facts` are the last known ones, by folder."""

    session: Session
    root: Path
    facts: Mapping[str, PackageFacts]


@dataclass(frozen=True)
class LintRun:
    """What a run came to."""

    scene: Scene
    order: LintOrder
    results: Results
    is_finished: bool
    """Whether it judged all packages."""


@dataclass
class LiveLint:
    """The packages around a folder, with what is known of them from earlier runs."""

    folder: Path
    memory: LivePackages = field(default_factory=LivePackages)
    root: Path = Path()
    stamps: DiskStamps | None = None
    facts: dict[str, PackageFacts] = field(default_factory=dict)
    failed: frozenset[str] = frozenset()
    """The packages on which a rule failed in the last run: nothing is kept of them."""

    def run(self, order: LintOrder, begins: Callable[[Scene], object] = lambda _: None) -> LintRun:
        """Lint what is judged already and the next packages; nothing is read of those in which nothing changed.

        `begins` is called with what the run will look at. Raises UserError for a config that is wrong, and
        RunInterrupted: what was found by then is kept, and the next order is to have these changes too.
        """
        self.memory.look = order.look
        configs = choose_configs([self.folder])
        order.look()
        located = locate([self.folder], None, configs)
        order.look()
        session = self.prepared(order, located, configs)
        begins(Scene(session, located.root, self.facts))
        results = session.run() if located.scope.folders else Results()
        known = {**self.facts, **self.memory.facts}
        self.facts = {folder: known[folder] for folder in session.scope.folders if folder in known}
        self.failed = session.scope.selected - self.memory.results.keys()
        is_finished = session.scope.selected == located.scope.selected
        return LintRun(Scene(session, located.root, self.facts), order, results, is_finished)

    def prepared(self, order: LintOrder, located: Located, configs: ConfigTree) -> Session:
        """Return the run over what is known already and the next packages."""
        session = make_session(LintOptions(), configs, located, no_progress)
        if located.root != self.root:
            self.root, self.memory, self.facts = located.root, LivePackages(look=order.look), {}
            self.failed, self.stamps = frozenset(), None
        changed = {*relative_to(order.changed, located.root), *self.changed_on_disk(order, located.scope)}
        self.memory.forget(changed, located.scope.folders)
        scope = session.scope
        around = [sorted(map(sorted, scope.repositories)), scope.folders, scope.cmake_projects]
        given = [scope.incomplete, sorted(scope.prefix_names), around]
        self.memory.require(repr([given, sorted(session.codes), session.settings, session.targets, configs.root]))
        tree = DiskTree(located.root, scope.folders)
        typed = {folder: self.facts[folder] for folder in self.facts if is_typed(located.root / folder, order.texts)}
        pool = partial(NotingPool, look=order.look, memory=self.memory, typed=typed)
        return replace(
            session,
            tree=overlay(tree, located.root, order.texts),
            scope=replace(scope, selected=self.next_packages(located, order.wanted)),
            kept=self.memory,
            make_pool=pool,
            make_small_pool=pool,
        )

    def changed_on_disk(self, order: LintOrder, scope: Scope) -> set[str]:
        """Return what has changed on disk since the last run without a report; nothing in the first run."""
        if order.on_disk is None:
            return set()
        is_first, self.stamps = self.stamps is None, self.stamps or DiskStamps(self.root)
        changed = self.stamps.changed(scope.folders)
        for path in () if is_first else changed:
            order.on_disk(self.root / path)
        return set() if is_first else changed

    def next_packages(self, located: Located, first: frozenset[Path]) -> frozenset[str]:
        """Return the packages that are judged already, those that are wanted, and some more."""
        scope = located.scope
        known = (self.memory.results.keys() | self.failed) & scope.selected
        wanted = {f for f in scope.selected if located.root / f in first}
        others = sorted(scope.selected - known - wanted)
        return frozenset(known | wanted | set(others[: 0 if wanted - known else CHUNK]))


def is_typed(package: Path, texts: Mapping[Path, OpenText]) -> bool:
    """Return whether the manifest of a package is in the editor and not saved."""
    path = package / "package.xml"
    if path not in texts:
        return False
    try:
        return path.read_bytes() != texts[path].data
    except OSError:
        return True


def relative_to(paths: Iterable[Path], root: Path) -> list[str]:
    """Return paths from a root; one outside of it as it is."""
    return [path.relative_to(root).as_posix() if path.is_relative_to(root) else str(path) for path in paths]
