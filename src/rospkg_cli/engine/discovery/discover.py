"""Find packages: every folder with a package.xml, as colcon finds them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence, Set
from pathlib import Path

from ...disk_trace import exists, is_file, real_path, scan
from ...fence import is_within
from ...gitignore import folders_above
from ...leftovers import is_build_output, is_made_package, is_never_source
from ...tree import Tree

REPOSITORY_MARKS = (".git",), (".github", ".gitlab-ci.yml", ".gitmodules", ".circleci", ".travis.yml")
"""Files in the root of a repository, by how sure they are: an export without .git has those that its host reads.

A copy of another repository has these as well, in the midst of one with a .git.
"""

IGNORE_MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE")

MAX_LINKED_FOLDERS = 1_000
"""How many links to folders are followed from one folder, so that links in circles end."""


class PassedBy:
    """Folders that a walk meets and that are no packages."""

    def __init__(self) -> None:
        self.plain: list[Path] = []
        """With a CMakeLists.txt and no package.xml."""
        self.outputs: list[Path] = []
        """What a build made, which is not looked into."""
        self.dotted: list[Path] = []
        """Those whose names begin with a dot, which colcon does not look into."""


def packages_below(
    root: Path, *, given: bool = True, marked: bool = False, passed: PassedBy | None = None
) -> Iterator[Path]:
    """Yield the package folders below a folder, sorted; nothing inside a package, nothing below an ignore marker.

    A folder that is `given` is looked into even when it is marked; every folder is where `marked` ones count.
    Links to folders are followed as colcon does, each package once, and under its own path where it has one here.
    What it passes by is added to `passed`.
    """
    found: dict[str, Path] = {}
    passed = passed or PassedBy()
    links = list(crawl(root, found, passed, given, marked))
    top = real_path(root)
    seen = {top}
    for _ in range(MAX_LINKED_FOLDERS):
        if not links:
            break
        link = links.pop(0)
        real = real_path(link)
        if real not in seen and not is_within(top, real):
            seen.add(real)
            links += crawl(link, found, passed, False, marked)
    yield from sorted(found.values())


def crawl(root: Path, found: dict[str, Path], passed: PassedBy, given: bool, marked: bool) -> Iterator[Path]:
    """Add the packages below a folder to `found`, by where they really lie; yield the links to folders met."""
    waiting = [root]
    while waiting:
        folder = waiting.pop()
        try:
            entries = {entry.name: entry for entry in scan(folder) if not is_never_source(entry.name)}
        except OSError:
            continue
        if not (marked or (given and folder == root)) and not entries.keys().isdisjoint(IGNORE_MARKERS):
            continue
        is_package = "package.xml" in entries and is_there(entries["package.xml"])
        if folder != root and is_made(root, folder, entries.keys(), is_package):
            passed.outputs.append(folder)
        elif is_package:
            found.setdefault(real_path(folder), folder)
        else:
            passed.plain += [folder] if "CMakeLists.txt" in entries else []
            shown = [entry for name, entry in entries.items() if not name.startswith(".")]  # as colcon's crawl does
            hidden = (entry for name, entry in entries.items() if name.startswith("."))
            passed.dotted += [Path(each.path) for each in hidden if each.is_dir(follow_symlinks=False)]
            waiting += [Path(each.path) for each in shown if each.is_dir(follow_symlinks=False)]
            yield from sorted(Path(each.path) for each in shown if each.is_symlink() and is_folder(each))


def is_made(root: Path, folder: Path, names: Set[str], is_package: bool) -> bool:
    """Return whether a folder below a root is output of a build; one with a package.xml only where that is, too."""
    if is_package:
        return is_made_package(f"{root.name}/{folder.relative_to(root).as_posix()}", names)
    return is_build_output(folder.name, names)


def is_there(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_file()
    except OSError:
        return False


def is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:
        return False


def marker_above(package: Path, below: Path) -> Path | None:
    """Return the outermost ignore marker that hides a package from a walk that starts at `below`."""
    inner = [folder for folder in (package, *package.parents) if folder != below and folder.is_relative_to(below)]
    marks = (folder / name for folder in reversed(inner) for name in IGNORE_MARKERS)
    return next((mark for mark in marks if exists(mark)), None)


def repositories(folders: Iterable[str], marked: Callable[[str, Sequence[str]], bool]) -> tuple[frozenset[str], ...]:
    """Return the packages of each repository: those whose nearest marked folder is the same.

    Folders are relative to the root of the run; what lies above that is not looked at.
    """
    found: dict[str, set[str]] = {}
    for folder in folders:
        around = sorted(folders_above(f"{folder}/package.xml".lstrip("/")), key=len, reverse=True)
        every = (each for marks in REPOSITORY_MARKS for each in around if marked(each, marks))
        if (here := next(every, None)) is not None:
            found.setdefault(here, set()).add(folder)
    return tuple(frozenset(found[root]) for root in sorted(found))


def enclosing_package(path: Path) -> Path | None:
    """Return the nearest folder at or above a path that holds a package.xml."""
    for folder in (path, *path.parents):
        if is_file(folder / "package.xml"):
            return folder
    return None


def repositories_in(tree: Tree) -> tuple[frozenset[str], ...]:
    """Return the packages of each repository of a tree in memory."""
    paths = [path + "/" for path in tree.files()]

    def marked(folder: str, marks: Sequence[str]) -> bool:
        starts = tuple(f"{folder}/{mark}/".lstrip("/") for mark in marks)
        return any(path.startswith(starts) for path in paths)

    return repositories(packages_in(tree), marked)


def packages_in(tree: Tree) -> list[str]:
    """Return the folders of the packages of a tree in memory ("" for its root)."""
    found = sorted(p.rpartition("/")[0] for p in tree.files() if p.rpartition("/")[2] == "package.xml")
    return [
        f
        for f in found
        if not any(f != outer and (f + "/").startswith(outer + "/" if outer else "") for outer in found)
    ]
