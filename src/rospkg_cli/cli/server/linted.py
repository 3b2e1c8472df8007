"""What a run over a workspace came to, with the texts that it saw."""

from __future__ import annotations

from collections import defaultdict
from functools import cached_property
from pathlib import Path

from ...engine.run.session import Session
from ...finding import Finding
from ...light_dataclasses import dataclass, field
from ...source import Source


@dataclass
class Linted:
    """The findings of one run, and the texts that their places are in."""

    session: Session
    root: Path
    findings: tuple[Finding, ...]
    _sources: dict[str, Source] = field(default_factory=dict, init=False, repr=False)

    def source(self, path: str) -> Source:
        """Return the text of a path below the root as it was linted; an empty one where it has none."""
        if path not in self._sources:
            try:
                text = self.session.tree.entry(path).text.text
            except (OSError, UnicodeError):
                text = ""
            self._sources[path] = Source(path, text)
        return self._sources[path]

    @cached_property
    def by_file(self) -> dict[Path, list[Finding]]:
        """The findings by the absolute path of their file."""
        found = defaultdict(list)
        for finding in self.findings:
            found[self.root / finding.location.path].append(finding)
        return dict(found)
