"""Whether a text that names a robot means the file of that name in another folder, or of another package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection

from ...package.package_facts import PackageFacts

BETWEEN = r"(?:/|[\"']\s*,\s*[\"'])"
"""What stands between a folder and a file, in one path or as parts that are joined."""


def folders_of(path: str, package: PackageFacts) -> frozenset[str]:
    """Return the names of the folders that a robot of a package lies in: in the source, and where it is installed."""
    folder, name = posixpath.split(path)
    places = (posixpath.dirname(each) for each in package.share_files if posixpath.basename(each) == name)
    return frozenset(posixpath.basename(each) or package.name for each in (folder, *places))


def is_elsewhere(name: str, folders: Collection[str], text: str) -> bool:
    """Return whether each place of a text that names a file in full has a folder before it, and none of these.

    A name alone, or behind what is put in (`{folder}/arm.urdf`), may be of any folder.
    """
    full = re.compile(rf"(?:([\w.-]*\w){BETWEEN})?(?<![\w.-]){re.escape(name)}(?![\w.-])")
    before = [found.group(1) for found in full.finditer(text)]
    return bool(before) and all(each is not None and each not in folders for each in before)


def means_another(path: str, package: PackageFacts, words: Collection[str], others: Collection[PackageFacts]) -> bool:
    """Return whether the words of another package's text are of a file of this name that is not the one of a package.

    The text has none of its folders, and the file is not installed, or the text has a package and the folder in which
    that has a file of this name.
    """
    name, folders = posixpath.basename(path), folders_of(path, package)
    if name not in words or not folders.isdisjoint(words):
        return False
    having = ((each, file) for each in others for file in each.share_files if posixpath.basename(file) == name)
    is_other = any(each.name in words and posixpath.basename(posixpath.dirname(file)) in words for each, file in having)
    return is_other or path in package.uninstalled
