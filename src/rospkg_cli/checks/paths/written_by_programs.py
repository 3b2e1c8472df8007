"""Missing files that a program of the repository writes, as far as its code puts their names together.

The folder may be the share directory or the source; what is unknown in the name may be any text.
"""

from __future__ import annotations

import ast
import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.python.file import parse_python
from ...languages.python.nodes import last_name, nodes_of_kind
from ...languages.python.path_patterns import PathPatterns
from ...languages.python.written_places import commands, written_by
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...package.launch.joined_path import OPEN
from ...package.python.share_paths import SHARE
from ...tree import READABLE
from ...unreadable import UnreadableError

UNTIL_WRITTEN = "until `{}` has written it"
CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h")
OUTPUT = regex(r"(?:>>?|(?:^|\s)(?:-o|--out(?:put)?(?:[-_](?:file|path))?))[\s=]*[\"']?([^\s\"'>]+)")
SAVED_MAP = regex(r"\bmap_saver\w*\s(?:.*\s)?-f[\s=]*[\"']?([^\s\"']+)")
OWNER = regex(rf"{OPEN}/share/(\w+)/")


def writer_of(files: PackageFiles, package: str, path: str, *, is_named: bool = False, with_tests: bool = False) -> str:
    """Return the file, of the package or another one, whose code writes a file of a package; "" where none does.

    `is_named` asks for letters of its name in the code: its folder and suffix are not enough.
    """
    whole = PackageFiles(files.whole) if files.whole is not None else files
    start = f"{files.folder}/" if files.whole is not None and files.folder else ""
    kinds = whole.tree.files()
    for each in sorted(kinds, key=lambda each: (not each.startswith(start), each)):
        if kinds[each] in READABLE and each.endswith((".py", *CPP)) and may_hold(whole, each, path):
            own = each.removeprefix(start)
            if (with_tests or role_of(own) != "test") and writes(whole, each, package, path, is_named):
                return own
    return ""


def may_hold(files: PackageFiles, code: str, path: str) -> bool:
    """Return whether the letters that begin or end the name of a file, or its folder, stand in some code."""
    folder, name = posixpath.split(path)
    stem, end = posixpath.splitext(name)
    words = (stem[:3], stem[-3:], posixpath.basename(folder) or end)
    return any(files.holds(code, word.encode()) for word in words if word.isascii())


def writes(files: PackageFiles, code: str, package: str, path: str, is_named: bool) -> bool:
    if code.endswith(CPP):
        from .written_in_cpp import is_written_in_cpp  # few missing files are written by C++

        return is_written_in_cpp(code, files.readable_text(code), path)
    return any(may_be(pattern, package, path, is_named) for pattern in written_in_python(files, code))


def written_in_python(files: PackageFiles, code: str) -> Iterator[str]:
    """Yield the paths that Python code writes to, with a mark for what is unknown in them."""
    try:
        file = parse_python(files.source(code))
    except UnreadableError:
        return
    for any_value in (False, True):
        patterns = PathPatterns(file, OPEN, share_of, any_value)
        for call in nodes_of_kind(file.tree, ast.Call):
            yield from map(patterns.text, written_by(call))
            command = " ".join(map(patterns.text, commands(call, patterns.held)))
            yield from (found[1] for found in OUTPUT.finditer(command))
            yield from (f"{found[1]}.yaml" for found in SAVED_MAP.finditer(command))
        if not patterns.defaults:
            return


def share_of(call: ast.Call, patterns: PathPatterns) -> str:
    """Return how the share directory ends that a call returns."""
    match call:
        case ast.Call(func=ast.Attribute(value=ast.Call() as found, attr="perform")):
            return share_of(found, patterns)
        case ast.Call(args=[named, *_]) if last_name(call.func) in SHARE:
            package = patterns.text(named)
            return f"{OPEN}/share/{package}" if package and OPEN not in package else ""
    return ""


def may_be(pattern: str, package: str, path: str, is_named: bool) -> bool:
    """Return whether a path with unknown parts may be that of a file: letters of its name say so, or its folder."""
    (folder, name), (wanted, file) = posixpath.split(pattern), posixpath.split(path)
    stem, end = posixpath.splitext(name)
    owner = OWNER.search(pattern)
    if not folder or (owner and owner[1] != package) or not fits(name, file):
        return False
    here, other = posixpath.basename(folder), posixpath.basename(wanted)
    if not stem.replace(OPEN, "").strip("._-"):
        return not is_named and bool(end.strip(f".{OPEN}")) and here == other != ""
    return not other or fits(here, other)


def fits(pattern: str, text: str) -> bool:
    return re.fullmatch(".*".join(map(re.escape, pattern.split(OPEN))), text) is not None
