"""What other packages may know of a package that CMake builds."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import NamedTuple

from ..facts import Unknown
from ..files import Reading
from ..install import PYTHON, InstallTable, What
from .project import CMake
from .read import ROOT, builds_with_cmake
from .table import cmake_table

FIELDS: Mapping[What, Unknown] = {"executable": "executables", "share": "share_files", "module": "modules"}


class CMakeFacts(NamedTuple):
    executables: frozenset[str] = frozenset()
    share_files: frozenset[str] = frozenset()
    modules: frozenset[str] = frozenset()
    components: frozenset[str] = frozenset()
    unknown: frozenset[Unknown] = frozenset()


def cmake_facts(reading: Reading, name: str) -> CMakeFacts:
    """Return what CMake installs and registers; nothing for a package that it does not build."""
    if not reading.files.exists(ROOT) or not builds_with_cmake(reading):
        return CMakeFacts()
    cmake = reading.parts(CMake).only
    if cmake is None:
        return CMakeFacts(unknown=frozenset({*FIELDS.values(), "components"}))
    table = cmake_table(cmake, name)
    plugins = [component.plugin for component in cmake.components]
    unknown: set[Unknown] = {field for what, field in FIELDS.items() if not table.knows(what)}
    if not cmake.complete or any(not plugin.known for plugin in plugins):
        unknown.add("components")
    return CMakeFacts(
        frozenset(path for path, _ in table.below(f"lib/{name}")),
        frozenset(path for path, _ in table.below(f"share/{name}")),
        modules(table),
        frozenset(plugin.text for plugin in plugins if plugin.known),
        frozenset(unknown),
    )


def modules(table: InstallTable) -> frozenset[str]:
    return frozenset(filter(None, (module_name(PurePosixPath(path)) for path, _ in table.below(PYTHON))))


def module_name(path: PurePosixPath) -> str:
    """Return the dotted name of an installed Python file, "" for what is none."""
    if path.suffix != ".py":
        return ""
    return ".".join(path.parent.parts if path.stem == "__init__" else path.with_suffix("").parts)
