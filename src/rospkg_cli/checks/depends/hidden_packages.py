"""Packages of the repository in folders that colcon ignores: behind COLCON_IGNORE, or inside of another package."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...tree import READABLE
from ..repository.container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

NAME = regex(r"<name>\s*([\w-]+)\s*</name>")
BUILDS = (
    r"(?m)^[^#\n]*\b(?:COPY|ADD|RUN|cd|cp|mv|ln|rm|rsync|base-paths|paths|WORKDIR)\b"
    r"[^\n]*[ \t./\"']{0}/?(?=[\s\"';&]|/COLCON|$)"
)
"""A line that copies a folder to where it is built, goes there, or has colcon look there."""


@dataclass(frozen=True)
class HiddenPackages:
    files: PackageFiles
    workspace: Workspace

    def folder_of(self, name: str) -> str:
        """Return the folder that has the package.xml of a name which no package found here has; "" for none."""
        if self.files.whole is None or name in self.workspace.names:
            return ""
        return self.workspace.index_of(HiddenFolders).of(PackageFiles(self.files.whole)).get(name, "")

    def is_built(self, name: str) -> bool:
        """Return whether a container, a script or a page of the repository builds the folder of a package."""
        folder = self.folder_of(name)
        parts = folder.split("/") if folder else []
        above = ["/".join(parts[:end]) for end in range(len(parts), 0, -1)]
        ways = [re.compile(BUILDS.format(re.escape(each))) for each in above]
        return any(way.search(text) for way in ways for text in self.texts)

    def where(self, name: str) -> str:
        """Return where the sources of an unknown package are, and who builds them, as a sentence; "" where unknown."""
        folder = self.folder_of(name)
        if not folder:
            return ""
        if self.is_built(name):
            return f"its sources lie in `{folder}`, which a script or a page of this repository builds"
        return f"its sources lie in `{folder}`, where colcon does not look: build them as well"

    @cached_property
    def texts(self) -> tuple[str, ...]:
        called = files_called(self.files, OF_CONTAINER, OF_WORKFLOW, OF_SCRIPT)
        return tuple(whole.readable_text(path) for whole, path in called)


class HiddenFolders(dict[str, str]):
    """The folder of each package.xml of the run, by the name in it; a large repository is searched once."""

    is_filled = False

    def of(self, whole: PackageFiles) -> dict[str, str]:
        if not self.is_filled:
            self.is_filled = True
            for path, kind in whole.tree.files().items():
                if kind in READABLE and posixpath.basename(path) == "package.xml":
                    found = NAME.search(whole.readable_text(path))
                    self.setdefault(found[1] if found is not None else "", posixpath.dirname(path))
        return self
