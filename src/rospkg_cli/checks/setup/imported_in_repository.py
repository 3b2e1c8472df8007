"""Whether code of a repository imports a Python package, or names a module in it for an import at run time."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ..share.opened_elsewhere import live, opening

REACH = 1000
"""The most characters of the names that one statement imports."""


def is_imported_in_repository(files: PackageFiles, folder: str, name: str) -> bool:
    """Return whether code outside of a folder of a package imports what is in it; True where that code is not seen.

    `name` is the dotted name of the folder. Tests and unused code (`old/`) do not count, nor do files with a module of
    that name next to them, which they import instead.
    """
    if files.whole is None:
        return True
    every = PackageFiles(files.whole)
    own = f"{files.folder}/{folder}/" if files.folder else f"{folder}/"
    above, _, last = name.rpartition(".")
    paths = (path for path in opening(every.every) if not path.startswith(own) and every.holds(path, last.encode()))
    importing = (
        path for path in paths if above or not every.has_file(posixpath.join(posixpath.dirname(path), f"{last}.py"))
    )
    return any(names(live(every, path), above, last) for path in importing)


def names(text: str, above: str, last: str) -> bool:
    """Return whether a text has `my_pkg.speech`, `from my_pkg import speech`, or the same with dots in front."""
    parent, word = re.escape(above), re.escape(last)
    if re.search(rf"(?<![\w.]){parent}\.{word}(?!\w)" if above else rf"\b(?:import|from)[ \t]+{word}(?!\w)", text):
        return True
    if re.search(rf"\bfrom[ \t]+\.+(?:\w+\.)*{word}(?!\w)", text):
        return True
    taken = re.compile(rf"\bfrom[ \t]+(?:{parent}|\.+[\w.]*)[ \t]+import[ \t]*(\([^)]{{0,{REACH}}}|[^\n]{{0,{REACH}}})")
    return any(re.search(rf"\b{word}\b", match[1]) for match in taken.finditer(text))
