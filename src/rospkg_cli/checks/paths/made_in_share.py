"""Folders of a share directory that code makes, and fills, as it runs: an installed package need not have them."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from ...files import PackageFiles
from ...languages.python.file import parse_python
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.path_patterns import PathPatterns
from ...package.file_role import role_of
from ...package.launch.joined_path import OPEN
from ...unreadable import UnreadableError
from .written_by_programs import fits, share_of, written_in_python

MAKERS = {"makedirs": b"makedirs", "mkdir": b"mkdir"}


def is_made_in_share(files: PackageFiles, package: str, folder: str, paths: Sequence[str]) -> bool:
    """Return whether a file of code makes a folder in the share directory, and writes all of some files there."""
    share = f"{OPEN}/share/{package}/"
    for code in files.paths:
        is_code = code.endswith(".py") and role_of(code) not in ("test", "aside")
        if not is_code or not any(files.holds(code, word) for word in MAKERS.values()):
            continue
        if f"{share}{folder}" in map(without_end, made_in_python(files, code)):
            written = [each.removeprefix(share) for each in written_in_python(files, code) if each.startswith(share)]
            inside = [each for each in written if each.startswith(f"{folder}/")]
            if inside and all(any(fits(pattern, path) for pattern in inside) for path in paths):
                return True
    return False


def without_end(path: str) -> str:
    return path.rstrip("/")


def made_in_python(files: PackageFiles, code: str) -> Iterator[str]:
    """Yield the folders that Python code makes, with a mark for what is unknown in them."""
    try:
        file = parse_python(files.source(code))
    except UnreadableError:
        return
    patterns = PathPatterns(file, OPEN, share_of, any_value=False)
    for call in nodes_of_kind(file.tree, ast.Call):
        yield from map(patterns.text, made_by(call))


def made_by(call: ast.Call) -> Iterator[ast.expr]:
    """Yield the folder that a call makes: `worlds.mkdir()`, `os.makedirs(worlds)`."""
    match call:
        case ast.Call(func=ast.Attribute(value=ast.Name(id="os"), attr=name)) if name in MAKERS:
            yield from (*call.args[:1], *(each.value for each in call.keywords if each.arg in ("name", "path")))
        case ast.Call(func=ast.Attribute(value=path, attr="mkdir")):
            yield path
        case ast.Call(func=ast.Name(id=name), args=[path, *_]) if name in MAKERS:
            yield path
