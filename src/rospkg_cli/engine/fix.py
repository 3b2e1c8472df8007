"""Repair in rounds: apply what fits together, lint again, until nothing changes; nothing here touches the disk."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from ..finding import Finding, Fix, Safety
from ..model.files import PackageFiles
from ..model.package import Package
from ..tree import Tree
from .apply import Changes, apply_fixes
from .overlay import Overlay
from .session import Results, Session

MAX_ROUNDS = 12


@dataclass
class Repair:
    """What fixing came to."""

    results: Results
    """Of the last round."""
    changes: Changes = field(default_factory=dict)
    """Against the tree as it was; paths relative to the root of the run."""
    applied: list[Finding] = field(default_factory=list)
    refused: list[tuple[Finding, str]] = field(default_factory=list)
    """Findings whose fix was taken back, and why."""


def repair(session: Session, safety: Sequence[Safety]) -> Repair:
    """Fix everything that may be fixed and that the session's judge leaves."""
    tree, codes = session.tree, session.codes
    found = Repair(session.run())
    banned: set[tuple[str, str, str]] = set()
    for _ in range(MAX_ROUNDS):
        wanted = [f for f in found.results.findings if f.fix and f.fix.safety in safety and identity(f) not in banned]
        if not wanted:
            break
        overlay = Overlay(tree, found.changes)
        changes, applied, refused = one_round(overlay, session, wanted)
        banned |= {identity(finding) for finding, _ in refused}
        found.refused += refused
        if not applied:
            continue
        found.changes = {**found.changes, **changes}
        found.applied += applied
        again = replace(session, tree=Overlay(tree, found.changes), codes=codes)
        found.results = again.run()
    found.changes = {p: e for p, e in found.changes.items() if e != original(tree, p)}
    return found


def identity(finding: Finding) -> tuple[str, str, str]:
    return finding.code, finding.place.path, finding.message


def original(tree: Tree, path: str) -> object:
    try:
        return tree.entry(path)
    except OSError:
        return None


def one_round(
    tree: Overlay, session: Session, wanted: Sequence[Finding]
) -> tuple[Changes, list[Finding], list[tuple[Finding, str]]]:
    """Apply what fits together; what would make a readable file unreadable is taken back and said."""
    refused: list[tuple[Finding, str]] = []
    left = list(wanted)
    while left:
        fixes = [f.fix for f in left if f.fix]
        try:
            changes, taken = apply_fixes(tree, fixes)
        except (OSError, UnicodeError) as error:
            refused.append((left.pop(0), f"{error}"))
            continue
        broken = newly_broken(tree, changes, session.scope.folders)
        if not broken:
            return changes, [f for f in left if is_taken(f.fix, taken)], refused
        guilty = breakers(tree, session, [f for f in left if f.fix and any(o.path in broken for o in f.fix.operations)])
        refused += [(f, f"it would break `{next(iter(broken))}`: {next(iter(broken.values()))}") for f in guilty]
        left = [f for f in left if f not in guilty]
    return {}, [], refused


def breakers(tree: Overlay, session: Session, touching: Sequence[Finding]) -> list[Finding]:
    """Return the findings whose fix breaks a file by itself; all of them where only several together do."""
    guilty = [
        finding
        for finding in touching
        if finding.fix and newly_broken(tree, apply_fixes(tree, [finding.fix])[0], session.scope.folders)
    ]
    return guilty or list(touching)


def is_taken(fix: Fix | None, taken: Sequence[Fix]) -> bool:
    return any(fix is each or (fix is not None and fix.operations == each.operations) for each in taken)


def newly_broken(tree: Overlay, changes: Changes, folders: Sequence[str]) -> dict[str, str]:
    """Return the files that could be read before the changes and can't be after, with what is wrong."""
    after = Overlay(tree.base, {**tree.changes, **changes})
    touched = {folder for path in changes for folder in folders if not folder or path.startswith(folder + "/")}
    before_broken = unreadable(tree, touched)
    return {path: why for path, why in unreadable(after, touched).items() if path not in before_broken}


def unreadable(tree: Tree, folders: set[str]) -> dict[str, str]:
    found: dict[str, str] = {}
    for folder in folders:
        prefix = folder + "/" if folder else ""
        package = Package(PackageFiles(tree.sub(folder), folder))
        found |= {prefix + each.path: each.message for each in package.unreadable()}
    return found
