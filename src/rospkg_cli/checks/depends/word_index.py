"""Every word of a package's text files, by the purpose of the file: a use of any kind leaves a word there."""

from __future__ import annotations

from functools import cached_property
from pathlib import PurePosixPath
from typing import Literal

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of
from ...package.manifest import Manifest
from ...unreadable import UnreadableError

Purpose = Literal["build", "run", "test", "docs"]

COMPILED = frozenset(".c .cc .cpp .cxx .cu .h .hh .hpp .hxx .cuh .ipp .inl .tpp .msg .srv .action .idl .cmake".split())
DOCS = frozenset(".md .rst .txt .dox".split())
OTHERS = frozenset(
    ".py .xml .yaml .yml .launch .urdf .xacro .rviz .sdf .srdf .world .wbt .proto .cfg .toml .json .ini .sh"
    " .bash .lua .js .html .lisp .rs .in .em .ui .service .rules .perspective .repos .ipynb".split()
)
WORD = regex(r"[\w-]+")


@dataclass(frozen=True)
class WordIndex:
    files: PackageFiles
    manifest: Manifest
    cmake: CMake | None

    @cached_property
    def by_purpose(self) -> dict[Purpose, list[str]]:
        """The texts of compiled files, tests, documents and all other files; package.xml is left out."""
        found: dict[Purpose, list[str]] = {"build": [], "run": [], "test": [], "docs": []}
        for path in self.files.paths:
            purpose = self.purpose(path)
            if purpose is not None:
                try:
                    found[purpose].append(self.files.source(path).text)
                except UnreadableError:
                    continue
        for call in (*self.cmake.calls, *self.cmake.unreachable) if self.cmake else ():
            found["test" if call.testing else "build"] += (word.text for word in call.words)
        return found

    def purpose(self, path: str) -> Purpose | None:
        """Return the purpose of a file; None for what is no text, or is read as calls of CMake."""
        suffix = PurePosixPath(path).suffix
        if path.rpartition("/")[2].upper().startswith("CHANGELOG"):
            return None
        if path == "package.xml" or (path.endswith("CMakeLists.txt") and self.cmake is not None):
            return None
        if suffix in DOCS:
            return "docs"
        if suffix in COMPILED:
            return "test" if role_of(path) == "test" else "build"
        if suffix in OTHERS or (not suffix and self.files.is_executable(path)):
            return "test" if role_of(path) == "test" else "run"
        return None

    def has(self, name: str, *purposes: Purpose) -> bool:
        """Return whether files of one of some purposes (default: of all) have a name."""
        if (not purposes or "run" in purposes) and any(element.tag == name for element in self.manifest.exports):
            return True
        texts = (text for each in purposes or self.by_purpose for text in self.by_purpose[each])
        return bool(WORD.fullmatch(name)) and any(has_word(text, name) for text in texts)


def has_word(text: str, name: str) -> bool:
    """Return whether a name is a word of a text, with neither a letter nor a hyphen around it."""
    at = text.find(name)
    while at >= 0:
        end = at + len(name)
        if not (at and WORD.match(text, at - 1)) and not WORD.match(text, end):
            return True
        at = text.find(name, at + 1)
    return False
