"""One workspace that an editor has open: its texts, the runs over them, and what the last one found."""

from __future__ import annotations

from pathlib import Path

from ...engine.live.safe_point import RightOfWay, SafePoint
from ...light_dataclasses import dataclass, field
from ...package.run_events import RuleCrash
from .linted import Linted
from .live_lint import LintOrder, LiveLint, Scene
from .live_world import LiveWorld
from .open_text import OpenText


@dataclass
class LiveWorkspace:
    """The packages around a folder that is open in an editor; what is here belongs to the event loop."""

    folder: Path
    texts: dict[Path, OpenText] = field(default_factory=dict)
    """What is in the editor, by absolute path."""
    changed: set[Path] = field(default_factory=set)
    """The paths whose content is not what it was when the last run began."""
    running: frozenset[Path] = frozenset()
    """Those that the run which goes on has seen as new."""
    wanted: set[Path] = field(default_factory=set)
    """Packages that are linted first."""
    asked: set[Path] = field(default_factory=set)
    """The files for which actions are asked, or were in vain."""
    scene: Scene | None = None
    """What the last run was about, also while the first one goes on."""
    linted: Linted | None = None
    """What the last run came to."""
    is_current: bool = False
    """Whether the last run saw all texts as they are now."""
    is_finished: bool = False
    """Whether the last run judged all packages, or could not."""
    has_failed: bool = False
    """Whether the run over the texts as they are now came to nothing."""
    said: str = ""
    """Why the last run failed, as it was shown to the user."""
    crashes: dict[Path, RuleCrash] = field(default_factory=dict)
    """What failed outside of the runs, by the file where it did; forgotten when that changes."""
    look: SafePoint = field(default_factory=SafePoint)
    """Where the last run may be interrupted, and what is made of it."""
    lint: LiveLint = field(init=False)
    world: LiveWorld = field(default_factory=LiveWorld)

    def __post_init__(self) -> None:
        self.lint = LiveLint(self.folder)

    def put(self, path: Path, text: OpenText | None) -> None:
        """Take the text of an editor for that of a file; None gives the file back.

        What only opens, saves or closes a file changes nothing; a manifest that is saved is no longer being typed.
        """
        known = self.texts.pop(path, None)
        if text is not None:
            self.texts[path] = text
        is_typed = known is not None and text is not None and known.version != text.version
        before = content(path, known)
        if is_typed or before is None or before != content(path, text) or path.name == "package.xml":
            self.touch(path)

    def touch(self, path: Path) -> None:
        """Note that a file is not what it was, here or on disk; a run over what it was is given up."""
        self.look.end()
        self.changed.add(path)
        self.crashes.pop(path, None)
        self.is_current = self.has_failed = False

    def order(self, way: RightOfWay, *, is_reported: bool = True) -> LintOrder:
        """Return what the next run is to see; it waits while others have the right of way.

        `is_reported` says that the editor reports what changes on disk.
        """
        changed, self.changed, self.look = frozenset(self.changed), set(), SafePoint(way)
        self.running = changed
        on_disk = None if is_reported else self.world.written.put
        return LintOrder(dict(self.texts), changed, frozenset(self.wanted), self.look, on_disk)

    def begin(self, scene: Scene) -> None:
        """Take what the first run will look at, so that it can be looked up before that run ends."""
        self.scene = self.scene or scene

    def take(self, linted: Linted) -> bool:
        """Take what a run came to; return whether that is of the texts as they are now, else nothing is shown of it."""
        self.scene = linted.run.scene
        if not self.changed:
            self.linted, self.is_finished, self.running = linted, linted.run.is_finished, frozenset()
            self.is_current, self.has_failed, self.said = True, False, ""
        return self.is_current

    def give_back(self, order: LintOrder) -> None:
        """Take back an order whose run was interrupted: the next run sees its changes as new."""
        self.changed |= order.changed

    def fail(self, order: LintOrder) -> None:
        """Take back an order whose run failed; no other follows before something changes."""
        self.has_failed = not self.changed
        self.is_finished = True
        self.give_back(order)


def content(path: Path, text: OpenText | None) -> bytes | None:
    """Return what a file holds: the text of an editor, else what is on disk; None where there is neither."""
    if text is not None:
        return text.data
    try:
        return path.read_bytes()
    except OSError:
        return None
