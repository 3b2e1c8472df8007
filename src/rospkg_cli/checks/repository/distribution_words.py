"""Where a package says for which distribution it is, if no README, script or workflow does."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...tree import READABLE
from .denied_distributions import without_denied

CLEAR = "foxy|eloquent|jazzy|kilted|lyrical"
PLAIN = "bouncy|crystal|dashing|galactic|humble|iron|rolling"
"""English words as well: they count only next to `ros`, as a branch, or at the end of a file's name."""
BEFORE = (
    r"\bros[ _-]?2?[\s:/_(`'\"*-]{0,4}|/opt/ros/|/(?:tree|blob|raw)/|(?:-b|branch|checkout|distro)[\s:=/`'\"*]{1,4}"
)
AFTER = r"[ -]devel|[`'\"*]{0,2} branch|\s+ros\b|\s+(?:diademata|geochelone|hawksbill|irwini|ridley)"
NAMES = regex(
    rf"(?<![a-z])({CLEAR})(?![a-z])|(?:{BEFORE})({PLAIN})(?![a-z])|(?<![a-z])({PLAIN})(?:{AFTER})"
    r"|\bros\.org/[a-z]{2}/(galactic|humble|iron)/"
)
IN_NAME = regex(rf"(?<![a-z])(?:({CLEAR})(?![a-z])|({PLAIN})(?=\.|$))")
SUFFIX = regex(rf"[_.-]?(?:{CLEAR}|{PLAIN})(?![a-z])")
DOCSTRING = regex(r"""(?s)(?:\s|#[^\n]*\n)*[rR]?(?:\"{3}(.{1,4000}?)\"{3}|'{3}(.{1,4000}?)'{3})""")
ASKS = "DISTRO"
"""What a launch file says that tests on which distribution it runs: it is for more than those that it names."""
PAGES = (".md", ".rst")
HISTORY = ("changelog", "changes", "history", "news")
"""Pages that name distributions of old on purpose."""


def words_of_package(files: PackageFiles) -> frozenset[str]:
    """Return the distributions that its manifest, setup.py and the docstrings of its launch files name."""
    launch = (files.readable_text(path) for path in launch_files(files) if path.endswith(".py"))
    own = map(files.readable_text, ("package.xml", "setup.py"))
    return words_in((*own, *map(docstring, launch)))


def words_elsewhere(files: PackageFiles) -> Iterator[frozenset[str]]:
    """Yield the distributions that other pages name, the launch files and docstrings, and the names of files."""
    yield words_in(other_pages(files))
    texts = (files.readable_text(path) for path in launch_files(files))
    yield words_in(text for text in texts if ASKS not in text) | words_of_package(files)
    yield words_in(docstring(files.readable_text(path)) for path in files.paths if path.endswith(".py"))
    there = {path.lower() for path in files.paths}
    names = (posixpath.basename(path) for path in there if SUFFIX.sub("", path) not in there - {path})
    yield frozenset(filter(None, (name for each in names for found in IN_NAME.findall(each) for name in found)))


def launch_files(files: PackageFiles) -> Iterator[str]:
    return (path for path in files.paths if role_of(path) == "launch")


def other_pages(files: PackageFiles) -> Iterator[str]:
    """Yield what pages say that lie in the package, in a folder above it, or in the `doc` or `docs` of one."""
    yield from (files.readable_text(path) for path in files.paths if is_page(path))
    if files.whole is None:
        return
    whole, parts = PackageFiles(files.whole), files.folder.split("/") if files.folder else []
    above = {"/".join(parts[:depth]) for depth in range(len(parts))}
    within = tuple(posixpath.join(each, name) + "/" for each in above for name in ("doc", "docs"))
    for path, kind in files.whole.files().items():
        if kind in READABLE and is_page(path) and (posixpath.dirname(path) in above or path.startswith(within)):
            yield whole.readable_text(path)


def is_page(path: str) -> bool:
    return path.endswith(PAGES) and not posixpath.basename(path).lower().startswith(HISTORY)


def docstring(text: str) -> str:
    found = DOCSTRING.match(text)
    return "".join(filter(None, found.groups())) if found is not None else ""


def words_in(texts: Iterable[str]) -> frozenset[str]:
    said = (without_denied(text.lower()) for text in texts)
    return frozenset(filter(None, (name for text in said for found in NAMES.findall(text) for name in found)))
