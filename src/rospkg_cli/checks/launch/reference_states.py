"""Whether a file that a launch file names is absent, not installed, or installed at another path."""

from __future__ import annotations

import posixpath

from ...package.package_facts import PackageFacts
from ..paths.closest_path import closest_path
from .launch_context import LaunchContext
from .missing_reference import State


def state_of(scope: LaunchContext, facts: PackageFacts, path: str) -> tuple[State, str | None]:
    if facts is scope.package and scope.files.is_there(path):
        goes = scope.table.destination_of(path) if scope.table is not None else None
        return ("elsewhere", goes) if goes else ("not installed", None)
    if path in facts.uninstalled:
        return "not installed", None
    own = (scope.file.path, *scope.places) if facts is scope.package else ()  # a file that includes itself never ends
    return "absent", closest_path(path, [each for each in facts.share_files if each not in own])


def is_brought(scope: LaunchContext, facts: PackageFacts, path: str) -> bool:
    """Return whether a build, a submodule, or a program of the package may bring a file of it."""
    if path in facts.run_time_files:
        return True
    if facts is scope.package:
        return scope.files.absent.is_expected(path)
    return scope.files.absent_in(facts.folder).is_ignored(path)


def is_in_nested(scope: LaunchContext, path: str) -> bool:
    """Return whether the launch file is of a package inside of this one, of the same name, that has a file."""
    folder = posixpath.dirname(scope.file.path)
    while folder and not scope.files.has_file(f"{folder}/package.xml"):
        folder = posixpath.dirname(folder)
    if not folder or not scope.files.is_there(f"{folder}/{path}"):
        return False
    return f"<name>{scope.package.name}</name>" in scope.files.readable_text(f"{folder}/package.xml")
