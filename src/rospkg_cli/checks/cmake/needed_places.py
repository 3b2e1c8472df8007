"""Whether the build needs a folder that a CMake command names: it finds the files in it nowhere else."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import SOURCE, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of

FOR_HEADERS = ("include_directories", "target_include_directories")
FOR_LIBRARIES = ("link_directories", "target_link_directories")
KEYWORDS = frozenset("PUBLIC PRIVATE INTERFACE SYSTEM BEFORE AFTER".split())
CPP = (".cpp", ".cc", ".cxx", ".c", ".cu", ".hpp", ".h", ".hh", ".hxx")
LIBRARIES = (".so", ".a", ".dylib", ".lib", ".dll")
INCLUDE = regex(r"^[ \t]*#[ \t]*include[ \t]*([<\"])([^>\"\n]+)[>\"]", re.MULTILINE)
BUILT = regex(r"\$<BUILD_INTERFACE:([^$<>]*)>")


@dataclass(frozen=True)
class NeededPlaces:
    cmake: CMake

    def why_not(self, call: EvaluatedCommand, folder: str) -> str:
        """Return why nothing is lost where a call misses a place of the package that it means; "" where something is.

        A folder of headers is needed where a source includes one of them that is found neither next to it nor in
        another folder, one of libraries where any lie there, and a value where something reads it.
        """
        if call.name in FOR_HEADERS:
            return "" if any(True for _ in self.lost_headers(folder)) else "all headers are found without it"
        if call.name in FOR_LIBRARIES:
            below = self.cmake.package_files.below(folder)
            is_needed = any(path.endswith(LIBRARIES) or ".so." in path for path in below)
            return "" if is_needed else "no library lies there"
        return self.why_unread(call) or ("it is only shown" if call.name == "message" else "")

    def why_unread(self, call: EvaluatedCommand) -> str:
        """Return that nothing reads the variable that a call sets; "" of other calls, and where something may."""
        is_idle = call.name == "set" and bool(call.texts) and not self.is_read(call.texts[0])
        return f"nothing here reads `{call.texts[0]}`" if is_idle else ""

    def lost_headers(self, folder: str) -> Iterator[str]:
        """Yield each header that is included and found in a folder alone."""
        is_there = self.cmake.package_files.is_there
        for path, is_angled, header in self.includes:
            own_folder = () if is_angled else (posixpath.dirname(path),)
            places = (posixpath.normpath(posixpath.join(each, header)) for each in (*own_folder, *self.folders))
            if is_there(posixpath.normpath(posixpath.join(folder, header))) and not any(map(is_there, places)):
                yield header

    @cached_property
    def includes(self) -> tuple[tuple[str, bool, str], ...]:
        """What the C++ of the package includes: the file, whether in angle brackets, and the header."""
        files = self.cmake.package_files
        paths = [path for path in files.paths if path.endswith(CPP) and role_of(path) == "run"]
        texts = ((path, files.readable_text(path)) for path in paths)
        return tuple((path, found[1] == "<", found[2]) for path, text in texts for found in INCLUDE.finditer(text))

    @cached_property
    def folders(self) -> frozenset[str]:
        """The folders of the package that are include directories of any target."""
        words = ((word, call) for call in self.cmake.named(*FOR_HEADERS) for word in words_of(call))
        places = (path_in_package(text_of(word), call.folder) for word, call in words if not is_joined(text_of(word)))
        return frozenset(place for place in places if place is not None)

    def is_read(self, name: str) -> bool:
        """Return whether a variable is read: in another file of CMake, or by CMake itself."""
        if name.startswith(("CMAKE_", "BUILD_")):
            return True
        read = re.compile(rf"\$\{{{re.escape(name)}\}}|\b(?:if|elseif)\s*\([^)]*(?<!\w){re.escape(name)}(?!\w)")
        return any(read.search(file.source.text) for file in self.cmake.files)


def words_of(call: EvaluatedCommand) -> Iterator[Word]:
    words = call.words[1:] if call.name.startswith("target_") else call.words
    return (word for word in words if word.text not in KEYWORDS)


def text_of(word: Word) -> str:
    built = BUILT.fullmatch(word.text)
    return built[1] if built else word.text


def is_joined(text: str) -> bool:
    """Return whether a text begins with the folder of the package and goes on without a slash: it is no folder."""
    return text.startswith(SOURCE) and text[len(SOURCE) : len(SOURCE) + 1] not in ("", "/")
