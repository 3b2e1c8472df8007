"""Scripts whose install rule is commented out, and that no page, script or launch file starts."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable

from ...files import PackageFiles
from ...languages.cmake.file import CMakeFile
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ..repository.pages_and_scripts import pages_and_scripts
from ..repository.scripts_above import scripts_above
from .commented_installs import said_in

INSTALLS = regex(r"\binstall\s*\(\s*(?:PROGRAMS|FILES)\b([^()]*)", re.IGNORECASE)
NAMES = regex(r"[^\s\"]+\.py\b")
STARTING = (".json", ".service", ".desktop", ".conf")


def scripts_in_comments(cmake: CMake, files: PackageFiles, scripts: Iterable[str]) -> frozenset[str]:
    """Return those of some scripts that a comment alone installs; one that another file names may be started."""
    names = {posixpath.basename(each) for each in commented(cmake)}
    found = [path for path in scripts if posixpath.basename(path) in names]
    return frozenset(path for path in found if not is_named(path, cmake, files))


def is_named(path: str, cmake: CMake, files: PackageFiles) -> bool:
    """Return whether a text has a script by its name, or code has it as a module or a file: a node may be called so."""
    name = posixpath.basename(path)
    word = re.compile(rf"(?<![\w-]){re.escape(name.removesuffix('.py'))}(?![\w-])")
    texts = (*pages_and_scripts(files), *scripts_above(files), *map(without_comments, cmake.files))
    if any(map(word.search, texts)) or is_launched(word.pattern, files):
        return True
    code = re.compile(rf"{re.escape(name)}|\b(?:import|from)\b[^\n'\"#]*{word.pattern}")
    others = (each for each in files.paths if each.endswith(".py") and each not in (path, "setup.py"))
    return any(code.search(files.readable_text(each)) for each in others if role_of(each) != "test")


def is_launched(word: str, files: PackageFiles) -> bool:
    """Return whether a launch file or the like has a script by its name, other than as the name of a node."""
    started = re.compile(rf"(\bname[\"']?\s*[=:]\s*)?(?:[\"'/]|\bexec:\s*){word}")
    paths = [each for each in files.paths if each.endswith(STARTING) or role_of(each) == "launch"]
    return any(not each[1] for path in paths for each in started.finditer(live_text(files, path)))


def without_comments(file: CMakeFile) -> str:
    """Return the text of a CMake file without its comments, those in brackets as well."""
    pieces, at = [], 0
    for span in sorted(file.syntax.comments, key=lambda each: each.start):
        pieces.append(file.source.text[at : span.start])
        at = span.end
    return " ".join([*pieces, file.source.text[at:]])


def commented(cmake: CMake) -> Iterable[str]:
    """Yield the Python files that comments install, as they are written."""
    for file in cmake.files:
        for words in INSTALLS.findall(said_in(file)):
            yield from NAMES.findall(words)
