"""Files that the Python code of a package writes into its share directory when it runs."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.python.file import PythonFile
from ...languages.python.joined_paths import PathJoiner
from ...languages.python.nodes import last_name, nodes_of_kind
from ...lazy_regex import regex
from ..file_role import role_of
from ..manifest import Manifest
from ..python_modules import PythonModules
from .share_paths import share_of

WRITES = regex(r"\bopen\s*\(|\bwrite_(?:text|bytes)\b|\bcopy")
MODE = regex(r"[bt+]{0,2}[wxa][bt+]{0,2}")
TEXT_WRITERS = frozenset({"write_text", "write_bytes"})
COPIES = frozenset({"copy", "copy2", "copyfile"})


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
    for call in nodes_of_kind(file.tree, ast.Call):
        target = written_by(call)
        path = joiner.path(target) if target is not None else None
        if path is not None and path[0] == package and path[1].startswith("/"):
            yield posixpath.normpath(path[1].lstrip("/"))


def written_by(call: ast.Call) -> ast.expr | None:
    """Return the path that a call writes to: `open(path, "w")`, `path.write_text(…)`, `shutil.copy(other, path)`."""
    name, method = last_name(call.func), call.func.value if isinstance(call.func, ast.Attribute) else None
    if name == "open":
        first = call.args[0] if call.args else None
        if is_mode(first) and method is not None:
            return method
        modes = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
        return (first or method) if any(map(is_mode, modes)) else None
    if name in TEXT_WRITERS:
        return method
    return call.args[1] if name in COPIES and len(call.args) > 1 else None


def is_mode(node: ast.expr | None) -> bool:
    """Return whether a literal is a mode in which open() makes a file that is not there."""
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and MODE.fullmatch(node.value) is not None
