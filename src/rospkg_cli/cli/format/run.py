"""`rospkg format`: package.xml in canonical order, on disk."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path, PurePosixPath

from ...checks.read_sentences import what_is_wrong
from ...control_characters import visible
from ...current_folder import current_folder
from ...disk import DiskTree
from ...edits.format_manifest import format_edits
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import locate
from ...engine.fixing.apply import Changes, edited
from ...engine.fixing.write import write_changes
from ...files import PackageFiles
from ...unreadable import Unreadable, UnreadableError
from .. import UsageError
from ..diff import unified
from ..streams import say


def format_manifests(paths: Sequence[Path], check: bool = False, diff: bool = False) -> int:
    """Format the package.xml of every package that the paths mean; return the exit status.

    0: done, or nothing to do. 1: one can't be read, or `check` or `diff` (which write nothing) would change one.
    Raises UsageError where no package is found; LocateError, ConfigError, WriteError.
    """
    paths = paths or (Path(),)
    located = locate(paths, None, choose_configs(paths))
    if not located.scope.selected:
        names = ", ".join(f"`{path}`" for path in paths)
        why = f": {located.hidden}" if located.hidden else ""
        raise UsageError(f"there is no package.xml under {names}{why}; give the path of a package or a workspace")
    tree = DiskTree(located.root, located.scope.folders)
    changes, broken = changes_of(tree, sorted(located.scope.selected))
    for path, unreadable in broken.items():
        say(f"{relative(located.root / path)}: {what_is_wrong(unreadable)}; it is left alone")
    if diff:
        sys.stdout.writelines(unified(tree, changes))
    elif not check:
        write_changes(located.root, tree, changes, tree.fence)
    verb = "would be formatted" if check or diff else "formatted"
    for path in sorted(changes):
        print(f"{verb}: {visible(relative(located.root / path))}", file=sys.stderr if diff else sys.stdout)
    left = len(located.scope.selected) - len(changes) - len(broken)
    print(f"{len(changes)} {verb}, {left} already in order", file=sys.stderr)
    return 1 if broken or (changes and (check or diff)) else 0


def changes_of(tree: DiskTree, folders: Sequence[str]) -> tuple[Changes, dict[str, Unreadable]]:
    """Return what formatting makes of the manifests in some folders, and those that can't be read, by path."""
    changes: Changes = {}
    broken: dict[str, Unreadable] = {}
    for folder in folders:
        path = str(PurePosixPath(folder, "package.xml"))
        try:
            edits = format_edits(PackageFiles(tree).source(path))
        except UnreadableError as error:
            broken[path] = error.unreadable
            continue
        if edits:
            changes[path] = edited(tree.entry(path), edits)
    return changes, broken


def relative(path: Path) -> str:
    """Return a path as the user would type it from here."""
    return Path(os.path.relpath(path, current_folder())).as_posix()
