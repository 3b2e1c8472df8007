"""Edits that install one more file into the share directory, in the rule or entry of its folder."""

from __future__ import annotations

import posixpath

from ..finding import Edit
from ..package.cmake.cmake_project import CMake
from ..package.setup.setup_py import SetupPy
from .cmake_install import SHARE
from .cmake_rule_place import block, extend_or_add
from .data_files import add_data_entry, share_code
from .plain_names import PLAIN
from .setup_py import add_item, quoted


def install_for_cmake(cmake: CMake, name: str, path: str) -> tuple[Edit, ...]:
    """Name a file in the rule for its folder, or in a new rule; nothing where CMake would split it."""
    if not PLAIN.fullmatch(path):
        return ()
    folder = posixpath.dirname(path)
    place = posixpath.join(f"share/{name}", folder)
    lines = block(cmake.root, "FILES", path, posixpath.join(SHARE, folder))
    return (
        extend_or_add(
            cmake,
            lambda rule: rule.kind == "FILES" and rule.destination == place and rule.rename is None,
            path,
            lines,
        ),
    )


def install_for_setup(setup: SetupPy, name: str, path: str) -> tuple[Edit, ...]:
    """Name a file in the entry for its folder, where that is a list of names, or in a new entry."""
    folder = posixpath.dirname(path)
    place = posixpath.join(f"share/{name}", folder)
    for entry in setup.data_entries:
        found = entry.sources if entry.folder == place else None
        if found is not None and (edits := add_item(setup, found, quoted(setup, path))):
            return edits
    return add_data_entry(setup, share_code(setup, name, *folder.split("/")), f"[{quoted(setup, path)}]")
