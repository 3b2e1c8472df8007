"""What the last run found, as far as it still holds in the texts that are in the editor now."""

from __future__ import annotations

from collections.abc import Mapping, Set
from pathlib import Path

from ...disk import DiskTree
from ...finding import Edit, Finding, Fix, Location, Operation
from ...light_dataclasses import dataclass, field, replace
from .kept_spans import KeptSpans
from .linted import Linted
from .open_text import OpenText
from .text_overlay import overlay


def carried(before: Linted, texts: Mapping[Path, OpenText], changed: Set[Path], path: Path) -> Linted:
    """Return the findings of a file whose text changed since they were found, and those of other files as they were.

    A finding is kept only where its lines, those of its related places and those that its fix changes are the same,
    and its fix touches no file that has `changed` on disk.
    """
    run = before.run
    tree = overlay(DiskTree(before.root, run.scene.session.scope.folders), before.root, texts)
    scene = replace(run.scene, session=replace(run.scene.session, tree=tree))
    now = Linted(replace(run, scene=scene, order=replace(run.order, texts=texts)), (), before.codec)
    carrier = Carrier(before, now, changed)
    own = [finding for each in before.by_file.get(path, []) if (finding := carrier.finding(each))]
    others = [each for each in before.findings if before.root / each.location.path != path]
    return replace(now, findings=(*own, *others))


@dataclass
class Carrier:
    """Moves findings from the texts of a run to others."""

    before: Linted
    now: Linted
    changed: Set[Path]
    known: dict[str, KeptSpans | None] = field(default_factory=dict)

    def kept(self, path: str) -> KeptSpans | None:
        """Return what is left of a text; None where that is not known."""
        if path not in self.known:
            whole = self.now.root / path
            is_open = whole in self.now.run.order.texts and whole in self.before.run.order.texts
            if not is_open and whole in self.changed:
                self.known[path] = None
            else:
                self.known[path] = KeptSpans.between(self.before.source(path).text, self.now.source(path).text)
        return self.known[path]

    def location(self, at: Location) -> Location | None:
        kept = self.kept(at.path)
        return kept.location(at) if kept else None

    def finding(self, finding: Finding) -> Finding | None:
        """Return a finding where it is now; None where it may be another one, or none."""
        at = self.location(finding.location)
        related = [(place, why) for each, why in finding.related if (place := self.location(each))]
        if at is None or len(related) < len(finding.related):
            return None
        if finding.fix is None:
            return replace(finding, location=at, related=tuple(related))
        operations = [found for each in finding.fix.operations if (found := self.operation(each))]
        if len(operations) < len(finding.fix.operations):
            return None
        fix = Fix(finding.fix.title, tuple(operations), finding.fix.safety)
        return replace(finding, location=at, related=tuple(related), fix=fix)

    def operation(self, operation: Operation) -> Operation | None:
        """Return what a fix does in the texts of now; None where that is not known."""
        if not isinstance(operation, Edit):
            return None if self.before.root / operation.path in self.changed else operation
        kept = self.kept(operation.path)
        span = kept.span(operation.span) if kept else None
        return replace(operation, span=span) if span else None
