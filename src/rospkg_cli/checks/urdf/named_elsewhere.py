"""Whether a text that names a robot means the file of that name in another folder, or of another package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace


@dataclass(frozen=True)
class NamedElsewhere:
    paths: frozenset[str]
    """The files of the package."""
    package: PackageFacts
    workspace: Workspace

    def is_elsewhere(self, path: str, text: str) -> bool:
        """Return whether each place of a text that names a file in full has a folder before it, and none of its own.

        A name alone, or behind what is put in (`{folder}/arm.urdf`), may be of any folder. A text before it, as in
        `join(share, 'urdf', 'arm.urdf')`, may be no folder: it is where files lie in one that is called so.
        """
        name = posixpath.basename(path)
        if name not in text:
            return False
        own = self.folders_of(path)
        full = re.compile(rf"(?:([\w.-]*\w)(/|[\"']\s*,\s*[\"']))?(?<![\w.-]){re.escape(name)}(?![\w.-])")
        found = [(each.group(1), each.group(2)) for each in full.finditer(text)]
        others = {last for last, _ in found} - {None} - own
        if not found or len(others) < len({last for last, _ in found}):
            return False
        joined = {last for last, between in found if between != "/"}
        return joined <= self.folders | {posixpath.basename(folder) for _, folder in self.having(name)}

    def means_another(self, path: str, words: Collection[str]) -> bool:
        """Return whether the words of another package's text are of a file of this name that is not this one.

        The text has none of its folders, and the file is not installed, or the text has a package and the folder in
        which that has a file of this name.
        """
        name = posixpath.basename(path)
        if name not in words or not self.folders_of(path).isdisjoint(words):
            return False
        is_other = any({owner, posixpath.basename(folder)} <= {*words} for owner, folder in self.having(name))
        return is_other or path in self.package.uninstalled

    def folders_of(self, path: str) -> frozenset[str]:
        """Return the names of the folders of a file: in the source, and where it is installed."""
        folder, name = posixpath.split(path)
        places = (place for owner, place in self.installed.get(name, ()) if owner == self.package.name)
        return frozenset(posixpath.basename(each) or self.package.name for each in (folder, *places))

    def having(self, name: str) -> list[tuple[str, str]]:
        """Return the other packages that install a file of a name, each with its folder in the share directory."""
        return [each for each in self.installed.get(name, ()) if each[0] != self.package.name]

    @cached_property
    def installed(self) -> dict[str, list[tuple[str, str]]]:
        """By the name of a file, the packages that install one, each with its folder in the share directory.

        Each robot is compared with each text: the files are gone through once, not for each pair.
        """
        found: dict[str, list[tuple[str, str]]] = {}
        for facts in (self.package, *(each for each in self.workspace.packages if each.name != self.package.name)):
            for path in facts.share_files:
                folder, name = posixpath.split(path)
                found.setdefault(name, []).append((facts.name, folder))
        return found

    @cached_property
    def folders(self) -> frozenset[str]:
        """The names of the folders of the package."""
        return frozenset(part for path in self.paths for part in posixpath.dirname(path).split("/"))
