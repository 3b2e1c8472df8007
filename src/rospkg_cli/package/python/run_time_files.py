"""Files that the Python code of a package writes into its share directory when it runs."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.python.file import PythonFile
from ...languages.python.joined_paths import PathJoiner
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.written_places import written_by
from ...lazy_regex import regex
from ..file_role import role_of
from ..manifest import Manifest
from ..python_modules import PythonModules
from .share_paths import share_of

WRITES = regex(r"\bopen\s*\(|write|\b(?:copy|move\b|rename\b|replace\b|save|to_(?:csv|json|excel)\b|imsave|touch\b)")


def run_time_files(reading: ReaderInput) -> frozenset[str]:
    """Return their paths relative to the share directory, as far as literals say them; what tests write is left out."""
    manifest, modules = reading.parts(Manifest).only, reading.parts(PythonModules).only
    found: set[str] = set()
    for path in reading.files.paths if manifest is not None and modules is not None else ():
        if not path.endswith(".py") or role_of(path) in ("test", "aside"):
            continue
        text = reading.files.readable_text(path)
        file = modules.at(path) if "get_package_share" in text and WRITES.search(text) and modules else None
        if file is not None and manifest is not None:
            found |= set(written_below(file, manifest.name))
    return frozenset(found)


def written_below(file: PythonFile, package: str) -> Iterator[str]:
    """Yield the paths below the share directory of a package that a file opens for writing, or copies to."""
    joiner = PathJoiner(file, share_of)
    for target in (each for call in nodes_of_kind(file.tree, ast.Call) for each in written_by(call)):
        path = joiner.path(target)
        if path is not None and path[0] == package and path[1].startswith("/"):
            yield posixpath.normpath(path[1].lstrip("/"))
