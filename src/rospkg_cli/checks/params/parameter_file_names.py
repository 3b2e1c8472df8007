"""Whether a file of a package names a parameter file in a way that may give it to a node."""

from __future__ import annotations

import posixpath
import re

from ...lazy_regex import regex

STARTING = regex(r"\.(?:py|xml|launch|launch\.ya?ml|sh|bash|[ch]pp|cc|service)$")
"""Files that give parameter files to nodes."""
DOCS = regex(r"\.(?:md|rst|txt)$")


def may_name(path: str) -> bool:
    """Return whether a file is a page, or one of those that give parameter files to nodes."""
    return DOCS.search(path) is not None or STARTING.search(path) is not None


def names_file(name: str, path: str, text: str, *, in_parts: bool) -> bool:
    """Return whether the text of such a file names a parameter file; a page does by a `params_file` argument.

    `in_parts` says that code of the package puts names of YAML files together: then the bare stem counts as well.
    """
    stem = re.escape(name.rpartition(".")[0])
    if DOCS.search(path):
        return re.search(rf"params[-_]file\S*[ \t]*\S*{re.escape(name)}", text) is not None
    if re.search(rf"[\"'/]{stem}\.", text) is not None:
        return True
    return in_parts and re.search(rf"[\"'/]{stem}[\"']", text) is not None


def named_in(folder: str, name: str, text: str) -> bool:
    """Return whether a text names a file together with its folder, as one path or in parts."""
    parts = rf"\b{re.escape(posixpath.basename(folder))}[\"'/,\s]+{re.escape(name.rpartition('.')[0])}\b"
    return re.search(parts, text) is not None
