"""From the faults that a check found in a file to the hits of a rule, each with its fix."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..checks.fault import Fault, TextRepair
from ..finding import Edit, Fix, Hit, Related, Safety, Severity


def hits(path: str, faults: Iterable[Fault]) -> Iterator[Hit]:
    """Yield a hit for each fault of the file at a path, relative to its package."""
    for fault in faults:
        related = tuple(Related(path, span, message) for span, message in fault.related)
        level = Severity(fault.level) if fault.level else None
        fix = fix_for(path, fault.repair) if fault.repair else None
        yield Hit(path, fault.span, fault.message, level, related, fix)


def fix_for(path: str, repair: TextRepair) -> Fix:
    """Return the fix that makes the edits of a repair in a file."""
    edits = tuple(Edit(path, span, text) for span, text in repair.edits)
    return Fix(repair.title, edits, Safety.SAFE if repair.is_certain else Safety.UNSAFE)
