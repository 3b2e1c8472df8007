"""What a run over a workspace came to, with the texts that it saw."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable
from functools import cached_property
from pathlib import Path

from lsprotocol import types
from pygls.workspace import PositionCodec

from ...engine.live.safe_point import never
from ...engine.run.session import Session
from ...finding import Finding
from ...light_dataclasses import dataclass, field
from ...package.run_events import RuleCrash
from ...report.shared_infos import with_shared_infos
from ...source import Source
from .diagnostics import diagnostic
from .live_lint import LintRun


@dataclass
class Linted:
    """The findings of one run, and the texts that their places are in."""

    run: LintRun
    findings: tuple[Finding, ...]
    codec: PositionCodec
    _sources: dict[str, Source] = field(default_factory=dict, init=False, repr=False)

    @classmethod
    def of(cls, run: LintRun, codec: PositionCodec, crashes: Iterable[RuleCrash] = ()) -> Linted:
        """Return what a run found, with what crashed during it."""
        found = run.scene.session.with_crashes(run.results, tuple(crashes))
        return cls(run, with_shared_infos(found.findings), codec)

    @property
    def session(self) -> Session:
        return self.run.scene.session

    @property
    def root(self) -> Path:
        return self.run.scene.root

    def source(self, path: str) -> Source:
        """Return the text of a path below the root as it was linted; an empty one where it has none."""
        if path not in self._sources:
            try:
                text = self.session.tree.entry(path).text.text
            except (OSError, UnicodeError):
                text = ""
            self._sources[path] = Source(path, text)
        return self._sources[path]

    def uri(self, path: str) -> str:
        """Return the address of a path below the root, as the editor writes it where it has the file open."""
        text = self.run.order.texts.get(self.root / path)
        return text.uri if text else (self.root / path).as_uri()

    def version(self, path: str) -> int | None:
        """Return the version of an open file that was linted: an editor refuses edits of another one."""
        text = self.run.order.texts.get(self.root / path)
        return text.version if text else None

    @cached_property
    def by_file(self) -> dict[Path, list[Finding]]:
        """The findings by the absolute path of their file."""
        found = defaultdict(list)
        for finding in self.findings:
            found[self.root / finding.location.path].append(finding)
        return dict(found)

    @cached_property
    def diagnostics(self) -> dict[Path, list[types.Diagnostic]]:
        """The findings as an editor shows them, by the absolute path of their file."""
        return self.shown()

    def make_ready(self) -> None:
        """Make what is shown, in the thread of the run: with a look after each file, at which it may be interrupted."""
        self.diagnostics = self.shown(self.run.order.look)

    def shown(self, look: Callable[[], None] = never) -> dict[Path, list[types.Diagnostic]]:
        found = {}
        for path, findings in self.by_file.items():
            found[path] = [diagnostic(each, self, self.codec) for each in findings]
            look()
        return found
