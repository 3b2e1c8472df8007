"""Whether another package of the workspace opens a folder in the share directory of a package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterator, Mapping, Sequence

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
BELOW = regex(r"([\w.-]+)(?:/|/?[\"']\s*[,/+]\s*[\"']/?)$")
"""The folder that a text joins a file name to: `config/a.yaml`, `'config', 'a.yaml'`, `'config' / 'a.yaml'`."""
REACH = 100
"""The most characters from there to the end of the name of the folder."""


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
    twins = twins_of(paths, files)
    if any(opens_folder_of(text, package, folder, twins) for text in opening_elsewhere(files, package, workspace)):
        return True
    whole = files.whole
    if whole is None:
        return False
    for facts in workspace.needing(package):
        theirs = PackageFiles(whole.sub(facts.folder), facts.folder, whole)
        own = {posixpath.basename(path) for path in theirs.paths}
        lacked = {name: folders for name, folders in twins.items() if name not in own}
        if any(names_one(live(theirs, path), package, lacked) for path in opening(theirs.paths)):
            return True
    return False


def twins_of(paths: Sequence[str], files: PackageFiles) -> dict[str, frozenset[str]]:
    """Return the names of some files, each with the names of other folders of the package that have a file of it."""
    own: dict[str, set[str]] = {}
    for path in paths:
        own.setdefault(posixpath.basename(path), set()).add(folder_name(path))
    others: dict[str, set[str]] = {name: set() for name in own}
    for path in files.paths:
        if (name := posixpath.basename(path)) in own and path not in paths:
            others[name].add(folder_name(path))
    return {name: frozenset(others[name] - own[name] - {""}) for name in own}


def folder_name(path: str) -> str:
    return posixpath.basename(posixpath.dirname(path))


def opens_folder_of(text: str, package: str, folder: str, twins: Mapping[str, Collection[str]]) -> bool:
    """Return whether a text opens a folder of a package, or a file in it: by its place, or by its name alone."""
    if not re.search(rf"(?<![\w-]){re.escape(package)}(?![\w-])", text):
        return False
    if names_one(text, package, twins) or (folder == BUILT_FROM and BUILDER.search(text)):
        return True
    return JoinedShares(text, package).join(rf"{re.escape(folder)}[\"'/]")


def names_one(text: str, package: str, twins: Mapping[str, Collection[str]]) -> bool:
    """Return whether a text has the name of a file; one joined to the share of another package is that of another.

    So is one that is joined to a folder which has a file of that name, too.

    Args:
        twins: the names, each with the names of such folders.
    """
    shares = JoinedShares(text, package)
    for name, folders in twins.items():
        word = rf"(?<![\w.-]){re.escape(name)}(?![\w-]|\.\w)" if name in text else ""
        places = [each for each in re.finditer(word, text) if word and joined_to(text, each.start()) not in folders]
        if any(shares.is_joined_here(each.end()) for each in places):
            return True
    return False


def joined_to(text: str, at: int) -> str:
    """Return the name of the folder that a text joins a file name to, which begins at a place; "" where it does not."""
    found = BELOW.search(text, max(0, at - REACH), at)
    return found[1] if found else ""


def opening(paths: tuple[str, ...]) -> Iterator[str]:
    """Yield the files that may open something when they are used."""
    return (path for path in paths if path.endswith(CODE) and role_of(path) not in ("test", "aside"))


def live(files: PackageFiles, path: str) -> str:
    """Return a text without its comments."""
    return without_comments(path, files.readable_text(path)) if path.endswith(CPP) else live_text(files, path)
