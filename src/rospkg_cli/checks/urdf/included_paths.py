"""Whether a robot includes a file of its package, by the folder of the file and not by its name alone."""

from __future__ import annotations

import posixpath
from collections.abc import Collection
from fnmatch import fnmatchcase

from ...lazy_regex import regex
from .xacro_includes import COMPUTED, INCLUDED

SHARE = regex(r"\$\(find\s+([^\s()]+)\s*\)/+")


def includes_path(by: str, text: str, path: str, package: str, known: Collection[str]) -> bool:
    """Return whether the text of a file of a package may include another of its files.

    Of several files with one name, the folder in the include decides, unless none of the `known` files is there: the
    installation may have moved it.
    """
    return any(leads_to(found.group(1), by, path, package, known) for found in INCLUDED.finditer(text))


def leads_to(named: str, by: str, path: str, package: str, known: Collection[str]) -> bool:
    name = path.rpartition("/")[2]
    last = COMPUTED.sub("*", named).rpartition("/")[2]
    if last != name and not ("*" in last and fnmatchcase(name, last)):
        return False
    share = SHARE.match(named)
    if share is not None and share.group(1) != package:
        return False
    rest = COMPUTED.sub("*", named[share.end() :] if share is not None else named)
    target = posixpath.normpath(rest if share is not None else posixpath.join(posixpath.dirname(by), rest))
    if rest.startswith("*"):
        return fnmatchcase(f"/{path}", rest if "/" not in rest else f"*{rest.lstrip('*')}")
    if "*" in target:
        return fnmatchcase(path, target)
    return path == target or target not in known
