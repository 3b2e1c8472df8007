"""The package's folder as the evaluated code sees it, below a root path of its own."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from fnmatch import translate
from functools import lru_cache
from typing import Literal

from ....files import PackageFiles
from ....lazy_regex import regex
from .limits import ITEM, STEP, spend

ROOT = "/<package>"
"""The absolute path of the package in evaluated texts."""

MAGIC = regex(r"[*?\[]")

MAX_DEPTH = 100
"""How many folders deep a search for modules or a `**` goes."""

MAX_PATH = 4096
"""Characters: no system takes a path of more."""

Kind = Literal["file", "dir", "unknown"]

SEEN_AS: dict[str, Kind] = {"dir": "dir", "linked-dir": "unknown", "linked-package": "unknown"}
"""How a folder of the tree is seen; the rest are files. setup.py can't copy a dead link or a FIFO."""


class OutsideError(Exception):
    """A path that is outside of the package, or behind a link to a folder, where files are unknown."""


class SandboxFilesystem:
    """Files and folders, by paths relative to the package ("" for the package itself)."""

    def __init__(self, files: PackageFiles) -> None:
        self.files = files
        self.children: dict[str, dict[str, Kind]] = {"": {}}
        for path, kind in files.tree.files().items():
            head, _, name = path.rpartition("/")
            inside = self.children.setdefault(head, {})
            if kind != "other":
                inside[name] = SEEN_AS.get(kind, "file")
            while head and head not in self.children.get(posixpath.dirname(head), {}):
                above = posixpath.dirname(head)
                self.children.setdefault(above, {})[posixpath.basename(head)] = "dir"
                head = above

    def inside(self, path: str, cwd: str = ROOT) -> str:
        """Return a path relative to the package; raises OutsideError."""
        whole = posixpath.normpath(posixpath.join(cwd, path))
        if whole == ROOT:
            return ""
        if not whole.startswith(ROOT + "/"):
            raise OutsideError(f"`{path}` lies outside of the package")
        return whole[len(ROOT) + 1 :]

    def kind(self, path: str) -> Kind | None:
        """Return the kind of a path in the package, None where there is nothing; raises OutsideError below a link."""
        if not path:
            return "dir"
        if len(path) > MAX_PATH:
            raise OutsideError("the path is longer than any may be")
        head, _, name = path.rpartition("/")
        if head in self.children:
            return self.children[head].get(name)
        while head and head not in self.children:
            link = head
            head, _, name = head.rpartition("/")
            if self.children.get(head, {}).get(name) == "unknown":
                raise OutsideError(f"`{link}` is a link to a folder")
        return None

    def may_hold_modules(self, path: str) -> bool:
        """Return whether an unknown path may be a Python package: a link to a folder without `__init__.py` is none."""
        return self.files.tree.files().get(path) != "linked-dir"

    def names(self, path: str) -> list[str]:
        """Return the names in a folder, sorted; [] where there is no folder; raises OutsideError at a link."""
        if self.kind(path) == "unknown":
            raise OutsideError(f"`{path}` is a link to a folder")
        names = self.children.get(path, {})
        spend(STEP + len(names) * ITEM)
        return sorted(names)

    def walk(self, path: str) -> Iterator[tuple[str, list[str], list[str]]]:
        """Yield folder, names of folders and names of files, from the top, as os.walk does."""
        waiting = [path]
        while waiting:
            path = waiting.pop()
            names = self.children.get(path, {})
            spend(STEP + len(names) * ITEM)
            folders = sorted(name for name, kind in names.items() if kind == "dir")
            yield path, folders, sorted(name for name, kind in names.items() if kind != "dir")
            waiting += [posixpath.join(path, name) for name in reversed(folders)]

    def glob(self, pattern: str, *, recursive: bool = False, cwd: str = ROOT) -> list[str]:
        """Return what glob.glob returns, sorted; raises OutsideError."""
        if len(pattern) > MAX_PATH or pattern.count("/") > MAX_DEPTH:
            raise OutsideError("the pattern is longer than any path")
        if not MAGIC.search(pattern):
            return [pattern] if self.is_there(pattern, cwd) else []
        head, name = posixpath.split(pattern)
        heads = self.glob(head, recursive=recursive, cwd=cwd) if MAGIC.search(head) else [head]
        found: list[str] = []
        for each in dict.fromkeys(heads):
            spend(STEP)
            inside = self.inside(each or ".", cwd)
            if recursive and name == "**":
                found += self.double_star_matches(each, inside)
            elif not name or not MAGIC.search(name):
                found += [posixpath.join(each, name)] if self.is_there(posixpath.join(each, name), cwd) else []
            else:
                found += [posixpath.join(each, n) for n in self.names(inside) if glob_matches(n, name)]
        return sorted(found)

    def is_there(self, path: str, cwd: str) -> bool:
        inside = self.inside(path, cwd)
        return self.kind(inside) == "dir" if path.endswith("/") else self.kind(inside) is not None

    def double_star_matches(self, shown: str, inside: str) -> list[str]:
        """Return what `**` matches: the folder itself, and all that is not hidden below it."""
        if inside.count("/") > MAX_DEPTH:
            raise OutsideError(f"`{inside[:80]}…` lies too deep")
        found = [posixpath.join(shown, "")] if self.kind(inside) == "dir" else []
        for name in self.names(inside):
            if not name.startswith("."):
                path = posixpath.join(inside, name)
                found.append(posixpath.join(shown, name))
                if self.kind(path) == "dir":
                    found += self.double_star_matches(posixpath.join(shown, name), path)[1:]
        return found


def glob_matches(name: str, pattern: str) -> bool:
    """Return whether glob matches a name: a hidden one only where the pattern begins with a dot."""
    return (pattern.startswith(".") or not name.startswith(".")) and bool(compile_glob(pattern).match(name))


@lru_cache(maxsize=256)
def compile_glob(pattern: str) -> re.Pattern[str]:
    return re.compile(translate(pattern))
