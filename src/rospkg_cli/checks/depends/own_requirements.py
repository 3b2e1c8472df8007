"""What setup.py has pip install where a page, a script or a Dockerfile has pip install the package itself."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...lazy_regex import regex

INSTALLS = regex(r"\bpip3?[ \t]+install\b([^\n&|;]*)")
EDITABLE = regex(r"(?<![\w-])(?:-e|--editable)(?![\w-])")
REQUIRES = regex(r"\binstall_requires[ \t]*=[ \t]*[\[(]([^\])]*)[\])]")
QUOTED = regex(r"[\"']([A-Za-z][\w.-]*)")
IN_CFG = regex(r"(?m)^install_requires[ \t]*=((?:[^\n]*\n)(?:[ \t]+[^\n]*\n|\n)*)")
LISTED = regex(r"(?m)^[ \t]*([A-Za-z][\w.-]*)")


def own_requirements(files: PackageFiles, texts: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Yield what setup.py requires, where one of some files, by path and text, has pip install the package."""
    required = list(required_by_setup(files))
    if required and any(has_own_folder(files, path, text) for path, text in texts):
        yield from required


def required_by_setup(files: PackageFiles) -> Iterator[str]:
    if files.exists("setup.py"):
        for found in REQUIRES.findall(files.readable_text("setup.py")):
            yield from QUOTED.findall(found)
    if files.exists("setup.cfg"):
        for found in IN_CFG.findall(files.readable_text("setup.cfg")):
            yield from LISTED.findall(found)


def has_own_folder(files: PackageFiles, path: str, text: str) -> bool:
    """Return whether a text has pip install the package's folder: by its name, or where people stand in it."""
    return any(means_own_folder(files, path, text, command) for command in INSTALLS.findall(text))


def links_own_folder(files: PackageFiles, path: str, text: str) -> bool:
    """Return whether a text has pip link to the package's folder, where its modules lie (`pip install -e .`)."""
    commands = (each for each in INSTALLS.findall(text) if EDITABLE.search(each))
    return any(means_own_folder(files, path, text, each) for each in commands)


def means_own_folder(files: PackageFiles, path: str, text: str, command: str) -> bool:
    own = posixpath.basename(files.folder)
    words = [word.strip("\"'`()").partition("[")[0].rstrip("/") for word in command.partition("`")[0].split()]
    if own and any("/" in word and posixpath.basename(word) == own for word in words):
        return True
    return "." in words and (not own or path in files.paths or is_named(own, text))


def is_named(folder: str, text: str) -> bool:
    return re.search(rf"(?<![\w-]){re.escape(folder)}(?![\w-])", text) is not None
