"""Whether code refers to a folder of a package's own share directory, by a search in its text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex

SHARE = regex(
    r"(?:get_package_share_(?:directory|path)|FindPackageShare)\s*\(\s*(?:package\s*=\s*)?(?:[\"']([\w-]+)[\"'])?"
    r"|\$\(find-pkg-share\s+([\w-]+)"
)
"""A lookup of a share directory: of a literal package name, or of one in a variable."""

ASSIGNED = regex(r"[ \t]*(\w+)\s*(?::[^=\n]*)?=[^=]")
REACH = 200
"""The most characters between a share directory and a folder that is joined to it."""


def references_folder(text: str, package: str, folder: str) -> bool:
    """Return whether a text joins a folder to the share directory of a package, or of an unknown one."""
    folder_offsets = [match.start() for match in re.finditer(rf"""["'/]{re.escape(folder)}["'/]""", text)]
    if not folder_offsets:
        return False
    references = sorted(share_directories(text))
    for at in folder_offsets:
        before = [name for place, name in references if at - REACH <= place <= at]
        if before and before[-1] in (package, ""):
            return True
    return False


def share_directories(text: str) -> Iterator[tuple[int, str]]:
    """Yield the offsets of references to share directories, with the package's name; "" where it is in a variable."""
    variables: dict[str, str] = {}
    for match in SHARE.finditer(text):
        name = match[1] or match[2] or ""
        yield match.start(), name
        line = text.rfind("\n", 0, match.start()) + 1
        if assigned := ASSIGNED.match(text, line, match.start()):
            variables[assigned[1]] = name
    for match in re.finditer(r"\w+", text) if variables else ():
        if match[0] in variables:
            yield match.start(), variables[match[0]]
