"""Whether more packages belong to a workspace than lie in it: lists for vcs and wstool, submodules that are empty."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...absent_paths import MAX_SUBMODULES, SUBMODULE
from ...disk_trace import is_file, is_folder, names_in, read_limited, scan
from ...lazy_regex import regex
from ...leftovers import is_never_source
from ...light_dataclasses import dataclass
from ...unreadable import UnreadableError
from .lists_by_content import MAX_BYTES, lists_among

URL = regex(r"^[ \t]*url[ \t]*=[ \t]*(\S+?)/?[ \t]*$", re.MULTILINE)

MAX_NAMED = 3
"""Repositories that a sentence names."""


@dataclass(frozen=True)
class MissingPackages:
    why: str = ""
    """What says that packages are not here, in a sentence that names the file; "" where nothing does."""
    repositories: frozenset[str] = frozenset()
    """The repositories that are listed and not here, as their lists call them; empty where one can't be read."""


def missing_packages(around: Path | None, packages: Sequence[Path]) -> MissingPackages:
    """Return what says that packages of a workspace are not here.

    Asked are a workspace, the folders right below it, and those above the packages. Where there is no workspace around,
    the folder that holds the packages is taken for it.
    """
    if around is None and not packages:
        return MissingPackages()
    top = around or Path(os.path.commonpath([package.parent for package in packages]))
    above = {folder for package in packages for folder in (package, *package.parents) if folder.is_relative_to(top)}
    folders = sorted({top, *above, *(children(top) if around else ())})
    found = [each for folder in folders for each in missing_below(folder, top)]
    are_known = all(each.repositories for each in found)
    repositories = frozenset(name for each in found for name in each.repositories) if are_known else frozenset[str]()
    return MissingPackages(found[0].why, repositories) if found else MissingPackages()


def children(folder: Path) -> Iterator[Path]:
    try:
        names = [entry.name for entry in scan(folder) if not is_never_source(entry.name)]
        yield from (folder / name for name in names if is_folder(folder / name))
    except OSError:
        return


def missing_below(folder: Path, top: Path) -> Iterator[MissingPackages]:
    """Yield what a folder's lists and submodules say of packages that are not here."""
    try:
        names = [entry.name for entry in scan(folder) if not is_never_source(entry.name)]
        for path in lists_among(folder, names):
            found = missing_of_list(path, top)
            if found.why:
                yield found
        paths = submodules(folder / ".gitmodules") if ".gitmodules" in names else []
    except OSError:
        return
    empty = [path for path in paths[:MAX_SUBMODULES] if is_empty(folder / path)]
    if empty:
        why = f"the submodule `{empty[0]}` is empty; `git submodule update --init` fills it"
        yield MissingPackages(why, frozenset((*empty, *addresses(folder / ".gitmodules", empty))))


def missing_of_list(path: Path, top: Path) -> MissingPackages:
    """Return what a list for vcs or wstool says of repositories that are not checked out."""
    from .listed_repositories import listed_repositories

    shown = path.relative_to(top).as_posix()
    try:
        data = read_limited(path)[1]
        listed = listed_repositories(data) if data is not None and len(data) <= MAX_BYTES else None
    except (OSError, UnreadableError, ValueError):
        listed = None
    if listed is None:
        return MissingPackages(f"`{shown}` lists repositories and can't be read")
    above = [folder for folder in (path.parent, *path.parent.parents) if folder.is_relative_to(top)]
    above += children(top)  # `vcs import external < ours.repos`
    places = [place for folder in above for place in (folder, folder / "src")]
    missing = [each for each in listed if not is_here(each, places)]
    if not missing:
        return MissingPackages()
    more = len(missing) - MAX_NAMED
    others = f" and {more} other{'s' if more > 1 else ''}" if more > 0 else ""
    why = f"`{shown}` lists repositories that are not here ({', '.join(missing[:MAX_NAMED])}{others})"
    return MissingPackages(why, frozenset(missing))


def is_here(repository: str, places: Sequence[Path]) -> bool:
    """Return whether a listed repository is checked out, where its list says or under its last name alone."""
    names = dict.fromkeys((repository, repository.rpartition("/")[2] or repository))
    return any(not is_empty(place / name) for place in places for name in names)


def submodules(path: Path) -> list[str]:
    """Return the folders that a .gitmodules names; raises OSError."""
    data = read_limited(path)[1] if is_file(path) else None
    return SUBMODULE.findall(data.decode("utf-8", "replace")) if data and len(data) <= MAX_BYTES else []


def addresses(path: Path, wanted: Sequence[str]) -> Iterator[str]:
    """Yield the last parts of the URLs of some submodules, where their folders are called otherwise; raises OSError."""
    text = read_limited(path)[1] or b""
    for section in text.decode("utf-8", "replace").split("[submodule")[1:]:
        folders = [each for each in SUBMODULE.findall(section) if each in wanted]
        for url in URL.findall(section) if folders else ():
            name = url.removesuffix(".git").rpartition("/")[2].rpartition(":")[2]
            if name and all(each.rpartition("/")[2] != name for each in folders):
                yield name


def is_empty(folder: Path) -> bool:
    """Return whether a repository is not checked out: its folder is missing, or holds nothing."""
    try:
        return not is_folder(folder) or not names_in(folder)
    except OSError:
        return False
