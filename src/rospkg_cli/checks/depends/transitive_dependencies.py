"""What comes with names that package.xml declares: members of metapackages, and exported dependencies."""

from __future__ import annotations

from collections.abc import Iterable

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import EXPORTED
from ...ros.read_table import rows

MAX_DEPTH = 20


def with_members(names: Iterable[str], workspace: Workspace) -> set[str]:
    """Return some names, and the members of the metapackages among them, at most MAX_DEPTH levels deep."""
    found: set[str] = set()
    waiting = [(name, 0) for name in names]
    while waiting:
        name, depth = waiting.pop()
        if name in found:
            continue
        found.add(name)
        facts = workspace.named(name)
        if depth < MAX_DEPTH:
            waiting += [(other, depth + 1) for other in metapackage_members(name, facts)]
    return found


def exported_by(names: Iterable[str], workspace: Workspace) -> tuple[frozenset[str], bool]:
    """Return what some packages export, directly or through others, and whether this is known of all of them."""
    found: set[str] = set()
    known, table = True, rows("exported_dependencies.txt")
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        facts = workspace.named(name)
        if facts is not None:
            needs = [need.name for need in facts.dependencies if need.tag in EXPORTED]
        else:
            needs = list(table.get(name, ()))
            known &= name in table or name.startswith("ament_") or workspace.index.is_key(name)
        waiting += [need for need in needs if need not in found]
        found.update(needs)
    return frozenset(found), known


def metapackage_members(name: str, facts: PackageFacts | None) -> Iterable[str]:
    """Return the members of a metapackage of the workspace or of the table; nothing for any other package."""
    if facts is None:
        return rows("metapackages.txt").get(name, ())
    return [need.name for need in facts.dependencies] if facts.is_metapackage else ()
