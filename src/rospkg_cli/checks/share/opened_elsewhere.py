"""Whether another package of the workspace opens a folder in the share directory of a package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ...package.workspace import Workspace
from ..paths.home_path_texts import without_comments
from .joined_shares import JoinedShares

CPP = (".cpp", ".cc", ".cxx", ".c", ".hpp", ".h")
CODE = (*CPP, ".py", ".xml", ".yaml", ".yml", ".urdf", ".xacro", ".sdf", ".world",
        ".rviz", ".launch")  # fmt: skip
"""The files that may open something at run time."""
BUILDER, BUILT_FROM = regex(r"\bMoveItConfigsBuilder\s*\("), "config"
"""What looks for its files in this folder by itself."""


def opening_elsewhere(files: PackageFiles, package: str, workspace: Workspace) -> Iterator[str]:
    """Yield the live texts of other packages that name a package."""
    if files.whole is None:
        return
    every = PackageFiles(files.whole)
    folders = tuple(f"{facts.folder}/" for facts in workspace.packages if facts.name != package and facts.folder)
    for path in opening(tuple(path for path in every.every if path.startswith(folders))):
        if package in every.readable_text(path):
            yield live(every, path)


def is_opened_elsewhere(
    folder: str, paths: Sequence[str], files: PackageFiles, package: str, workspace: Workspace
) -> bool:
    """Return whether another package opens a folder of a package, or one of the paths in it.

    It names this package and the file or the folder; or it needs this package, and names a file that it lacks itself.
    """
    if any(opens_folder_of(text, package, folder, paths) for text in opening_elsewhere(files, package, workspace)):
        return True
    whole = files.whole
    if whole is None:
        return False
    for facts in workspace.needing(package):
        theirs = PackageFiles(whole.sub(facts.folder), facts.folder, whole)
        own = {posixpath.basename(path) for path in theirs.paths}
        lacked = [path for path in paths if posixpath.basename(path) not in own]
        if any(names_one(live(theirs, path), package, lacked) for path in opening(theirs.paths)):
            return True
    return False


def opens_folder_of(text: str, package: str, folder: str, paths: Sequence[str]) -> bool:
    """Return whether a text opens a folder of a package, or a file in it: by its place, or by its name alone."""
    if not re.search(rf"(?<![\w-]){re.escape(package)}(?![\w-])", text):
        return False
    if names_one(text, package, paths) or (folder == BUILT_FROM and BUILDER.search(text)):
        return True
    return JoinedShares(text, package).join(rf"{re.escape(folder)}[\"'/]")


def names_one(text: str, package: str, paths: Sequence[str]) -> bool:
    """Return whether a text has the name of a file; one joined to the share of another package is that of another."""
    names = {posixpath.basename(path) for path in paths}
    words = (re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-]|\.\w)") for name in names if name in text)
    return any(map(JoinedShares(text, package).may_join, words))


def opening(paths: tuple[str, ...]) -> Iterator[str]:
    """Yield the files that may open something when they are used."""
    return (path for path in paths if path.endswith(CODE) and role_of(path) not in ("test", "aside"))


def live(files: PackageFiles, path: str) -> str:
    """Return a text without its comments."""
    return without_comments(path, files.readable_text(path)) if path.endswith(CPP) else live_text(files, path)
