"""One round of fixing: the fixes that fit together, without those that fail or would break a file."""

from __future__ import annotations

import traceback
from collections.abc import Collection, Iterable, Mapping, Sequence, Set
from contextlib import suppress
from zlib import crc32

from ...checks.read_sentences import what_is_wrong
from ...files import PackageFiles
from ...finding import Finding, Fix
from ...light_dataclasses import dataclass
from ...package.package import Package
from ...package.run_events import RuleCrash
from ...tree import Tree
from .apply import Changes, apply_fixes, paths_of
from .dependency_cycles import closing_cycles
from .overlay import Overlay
from .wider_declarations import needless

MAX_TRIED = 50
"""Of more fixes that touch a broken file, none is tried alone: each time a package is read."""


@dataclass(frozen=True)
class Refusal:
    """A fix that was not made, and why; with the crash where the fix raised an exception."""

    finding: Finding
    why: str
    crash: RuleCrash | None = None


def one_round(
    tree: Overlay, folders: Sequence[str], wanted: Sequence[Finding], checksums: Mapping[str, int]
) -> tuple[Changes, list[Finding], list[Refusal]]:
    """Apply what fits together; a fix that would make a readable file unreadable is refused.

    So is one whose file is no longer the one that the rules read: `checksums` tell.
    """
    changed = changed_meanwhile(tree, checksums)
    refused = [Refusal(each, why) for each in wanted if (why := stale(each, changed) or read_only(tree, each))]
    left = without(wanted, [each.finding for each in refused])
    if not can_apply(tree, left):
        failing = [found for each in left if (found := cannot_apply(tree, each))]
        left = without(left, [each.finding for each in failing])
        refused += failing
    cyclic = [Refusal(each, why) for each, why in closing_cycles(tree, folders, left)]
    left = without(left, [each.finding for each in cyclic])
    left = without(left, needless(left))  # what is still wanted then comes in the next round
    refused += cyclic
    while left:
        changes, taken = apply_fixes(tree, [each.fix for each in left if each.fix])
        broken = newly_unreadable(tree, changes, folders)
        if not broken:
            done = {fix.operations for fix in taken}
            return changes, [each for each in left if each.fix and each.fix.operations in done], refused
        guilty = breaking_fixes(tree, folders, left, broken)
        path, why = next(iter(broken.items()))
        refused += [Refusal(each, f"it would break `{path}`: {why}") for each in guilty]
        left = without(left, guilty)
    return {}, [], refused


def without(findings: Iterable[Finding], others: Iterable[Finding]) -> list[Finding]:
    """Return the findings but for some of them; equal ones are kept apart."""
    gone = set(map(id, others))
    return [each for each in findings if id(each) not in gone]


def changed_meanwhile(tree: Tree, checksums: Mapping[str, int]) -> set[str]:
    """Return the files that are not the ones of the checksums."""
    found = set()
    for path, checksum in checksums.items():
        try:
            is_same = crc32(tree.entry(path).data) == checksum
        except OSError:
            is_same = False
        found |= set() if is_same else {path}
    return found


def stale(finding: Finding, changed: Set[str]) -> str:
    """Return why a fix must not be made to files that have changed; "" where none has."""
    paths = sorted(o.path for o in finding.fix.operations if o.path in changed) if finding.fix else []
    return f"`{paths[0]}` was changed by someone else meanwhile; run again" if paths else ""


def read_only(tree: Tree, finding: Finding) -> str:
    """Return the file of a fix that may not be written; "" where there is none."""
    for path in sorted({each.path for each in finding.fix.operations} if finding.fix else ()):
        with suppress(OSError):
            if not tree.entry(path).mode & 0o222:
                return f"`{path}` is read-only"
    return ""


def can_apply(tree: Overlay, findings: Sequence[Finding]) -> bool:
    try:
        apply_fixes(tree, [each.fix for each in findings if each.fix])
    except Exception:
        return False
    return True


def cannot_apply(tree: Overlay, finding: Finding) -> Refusal | None:
    """Return why a fix can't be made even alone, or None."""
    try:
        apply_fixes(tree, [finding.fix] if finding.fix else [])
    except (OSError, UnicodeError) as error:
        return Refusal(finding, str(error))
    except Exception as error:
        crash = RuleCrash(finding.code, finding.package, finding.location.path, traceback.format_exc(), "fix of")
        return Refusal(finding, f"{type(error).__name__}: {error}", crash)
    return None


def breaking_fixes(
    tree: Overlay, folders: Sequence[str], left: Sequence[Finding], broken: dict[str, str]
) -> list[Finding]:
    """Return the findings whose fix breaks a file by itself; all that touch one where only several together do."""
    touching = [each for each in left if each.fix and touches(each.fix, broken)]
    if len(touching) > MAX_TRIED:
        return touching
    guilty = [
        each for each in touching if each.fix and newly_unreadable(tree, apply_fixes(tree, [each.fix])[0], folders)
    ]
    return guilty or touching


def touches(fix: Fix, paths: Collection[str]) -> bool:
    return any(path in paths for operation in fix.operations for path in paths_of(operation))


def newly_unreadable(tree: Overlay, changes: Changes, folders: Sequence[str]) -> dict[str, str]:
    """Return the changed files that could be read before and can't be after, with what is wrong.

    A file that was broken already, and is only now read because another was made, is not counted.
    """
    after = Overlay(tree.base, {**tree.changes, **changes})
    touched = {folder for path in changes for folder in folders if not folder or path.startswith(folder + "/")}
    broken = {path: why for path, why in unreadable_files(after, touched, changes).items() if path in changes}
    before = unreadable_files(tree, touched, changes) if broken else {}
    return {path: why for path, why in broken.items() if path not in before}


def unreadable_files(tree: Tree, folders: set[str], paths: Iterable[str]) -> dict[str, str]:
    """Return the files of some packages that can't be read, with what is wrong; at least those of `paths`."""
    found: dict[str, str] = {}
    for folder in folders:
        prefix = folder + "/" if folder else ""
        package = Package(PackageFiles(tree.sub(folder), folder))
        found |= {
            prefix + each.path: what_is_wrong(each)
            for each in package.unreadable(p for p in paths if p.startswith(prefix))
        }
    return found
