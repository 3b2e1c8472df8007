"""The files of one package, and the input of readers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fnmatch import fnmatchcase
from functools import cached_property
from typing import Generic, Protocol, TypeVar

from .absent_paths import AbsentPaths
from .file_text import read_text
from .light_dataclasses import dataclass
from .source import Source
from .tree import EXISTING, FILES, LINKED, Tree
from .unreadable import Unreadable, UnreadableError

UTF16 = (b"\xff\xfe", b"\xfe\xff")
"""The marks at the start of texts in which a letter takes two bytes."""

MAX_PAGE = 200_000
"""How many letters a page has at most that people read; what is longer is data or a log."""

T = TypeVar("T")
T_co = TypeVar("T_co", covariant=True)


@dataclass
class PackageFiles:
    """The files of the package in `folder` (relative to the root of the run, "" for the root itself)."""

    tree: Tree
    folder: str = ""
    whole: Tree | None = None
    """The tree of the run, for what may lie above the package."""

    def __post_init__(self) -> None:
        self._sources: dict[str, Source] = {}

    @cached_property
    def every(self) -> tuple[str, ...]:
        """Every file in the package's folder, sorted; those of packages below it too."""
        return tuple(sorted(path for path, kind in self.tree.files().items() if kind in FILES))

    @cached_property
    def paths(self) -> tuple[str, ...]:
        """Every file of the package, sorted; files of nested packages do not belong to it.

        A package.xml in the folder of a Python module makes no package of it: colcon does not look there, and
        setuptools installs the module.
        """
        below = (p[: -len("package.xml")] for p in self.every if p.endswith("/package.xml"))
        inner = tuple(folder for folder in below if f"{folder}__init__.py" not in self._every)
        return tuple(p for p in self.every if not p.startswith(inner)) if inner else self.every

    @cached_property
    def folders(self) -> frozenset[str]:
        """Every folder that holds a file of the package, at any depth."""
        return folders_of(self.paths)

    @cached_property
    def places(self) -> frozenset[str]:
        """Every file and every folder, an empty one too, in packages below too; a dead link is neither."""
        found = self.tree.files()
        return folders_of(found).union(path for path, kind in found.items() if kind in EXISTING)

    @cached_property
    def absent(self) -> AbsentPaths:
        """What a working tree lacks on purpose."""
        return AbsentPaths(self.tree, self.whole or self.tree, self.folder if self.whole is not None else "")

    def absent_in(self, folder: str) -> AbsentPaths:
        """Return what the package in another folder of the run lacks on purpose, as its .gitignore files say."""
        return AbsentPaths(self.tree, self.whole, folder) if self.whole is not None else self.absent

    def has_file(self, path: str) -> bool:
        """Return whether there is a file; one of a nested package counts."""
        return path in self._every

    def is_there(self, path: str) -> bool:
        """Return whether there is a file or folder; nested packages and what is behind a symlink count."""
        parts = path.split("/")
        links = ("/".join(parts[:end]) for end in range(1, len(parts)))
        return path in self.places or any(self.tree.files().get(link) in LINKED for link in links)

    @cached_property
    def _every(self) -> frozenset[str]:
        return frozenset(self.every)

    @cached_property
    def _set(self) -> frozenset[str]:
        return frozenset(self.paths)

    def exists(self, path: str) -> bool:
        return path in self._set

    def above(self, names: Iterable[str]) -> str | None:
        """Return the first of some files that a folder above the package holds, nearest first; None where none does."""
        wanted, parts = tuple(names), self.folder.split("/") if self.folder else []
        for depth in range(len(parts) - 1, -1, -1):
            for path in ("/".join([*parts[:depth], name]) for name in wanted):
                if self.whole is not None and has_file(self.whole, path):
                    return path
        return None

    def is_executable(self, path: str) -> bool:
        """Return whether a file may be executed; one that is not there or may not be looked at is not."""
        try:
            return self.tree.entry(path).is_executable
        except OSError:
            return False

    def below(self, folder: str) -> tuple[str, ...]:
        """Return the files at any depth below a folder ("" for all)."""
        prefix = folder.rstrip("/") + "/" if folder else ""
        return tuple(p for p in self.paths if p.startswith(prefix))

    def matching(self, pattern: str) -> tuple[str, ...]:
        """Return the files whose whole path fits a shell pattern, in which `*` crosses `/`."""
        return tuple(p for p in self.paths if fnmatchcase(p, pattern))

    def source(self, path: str) -> Source:
        """Return a file's text; raises UnreadableError where it has none."""
        if path not in self._sources:
            self._sources[path] = read_text(self.tree, path)
        return self._sources[path]

    def readable_text(self, path: str) -> str:
        """Return a file's text, "" where it has none: for what only looks for a word."""
        try:
            return self.source(path).text
        except UnreadableError:
            return ""

    def page_text(self, path: str) -> str:
        """Return what a page or script says; "" for more than anybody writes: measurements and logs are `.txt`, too."""
        text = self.readable_text(path)
        return text if len(text) <= MAX_PAGE else ""

    def holds(self, path: str, word: bytes) -> bool:
        """Return whether a word of ASCII stands in a file, which need not be decoded for that.

        False where it can't be read.
        """
        try:
            data = self.tree.entry(path).data
        except OSError:
            return False
        return word in data or (data[:2] in UTF16 and word.decode() in self.readable_text(path))


def has_file(tree: Tree, path: str) -> bool:
    """Return whether a file is there, without listing the whole tree."""
    try:
        tree.entry(path)
    except OSError:
        return False
    return True


def folders_of(paths: Iterable[str]) -> frozenset[str]:
    found = set()
    for path in paths:
        while "/" in path:
            path = path.rpartition("/")[0]
            if path in found:
                break
            found.add(path)
    return frozenset(found)


@dataclass(frozen=True)
class ReadModels(Generic[T_co]):
    """The result of a reader: the models that could be read, and the files that could not."""

    good: tuple[T_co, ...] = ()
    broken: tuple[Unreadable, ...] = ()

    @property
    def only(self) -> T_co | None:
        """The model of a file that a package has once, or None."""
        return self.good[0] if self.good else None


class ReaderInput(Protocol):
    """The input of a reader: the files, and other models of the same package."""

    @property
    def files(self) -> PackageFiles: ...

    def parts(self, kind: type[T]) -> ReadModels[T]: ...


def read_each(files: PackageFiles, paths: Iterable[str], read: Callable[[Source], T]) -> Iterator[T | Unreadable]:
    """Read every path on its own, so that one broken file does not hide the others."""
    for path in paths:
        try:
            yield read(files.source(path))
        except UnreadableError as error:
            yield error.unreadable
