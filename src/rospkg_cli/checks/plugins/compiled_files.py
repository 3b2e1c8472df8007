"""Whether a library or a program is made of a file: of a source itself, of a header by what includes it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from ...languages.cpp.file import CppFile
from ..cmake.source_targets import SourceTargets

HEADERS = (".h", ".hpp", ".hh")


def is_compiled(targets: SourceTargets, files: Sequence[CppFile], path: str) -> bool:
    """Return whether a target has a file, or one that includes it, as far as that is known."""
    found, waiting = {path}, [path]
    while waiting:
        path = waiting.pop()
        if targets.targets_of(path):
            return True
        more = [each for each in including(files, posixpath.basename(path)) if each not in found]
        found.update(more)
        waiting += more
    return False


def including(files: Sequence[CppFile], name: str) -> Iterator[str]:
    """Yield the files that include one of a name."""
    for file in files:
        if any(posixpath.basename(each.path) == name for each in file.includes):
            yield file.path
