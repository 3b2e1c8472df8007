"""What CMake finds along with some packages: what they export, directly or through others."""

from __future__ import annotations

from collections.abc import Collection

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.read_table import rows

TABLES = ("exported_dependencies", "runtime_dependencies")


def found_with(names: Collection[str], workspace: Workspace) -> tuple[frozenset[str], bool]:
    """Return some packages with all that they export, and whether that is known of all ROS packages among the first.

    Packages of the workspace are known by their manifests, others by tables.
    """
    found: set[str] = set()
    known, tables = True, [rows(f"{name}.txt") for name in TABLES]
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            facts = workspace.named(name)
            waiting += rows("cmake_exports.txt").get(name, ())
            if facts is not None:
                waiting += (*built_against(facts), *facts.typed_with)
                continue
            waiting += [need for table in tables for need in table.get(name, ())]
            listed = any(name in table for table in tables)
            known &= listed or name not in names or not workspace.index.is_package(name)
    return frozenset(found), known


def built_against(facts: PackageFacts, *tags: str) -> list[str]:
    return [need.name for need in facts.dependencies if need.tag in ("depend", "build_export_depend", *tags)]
