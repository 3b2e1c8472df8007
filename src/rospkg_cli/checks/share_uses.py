"""Whether code, launch files or robots of a package open a folder of its share directory."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cached_property

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.launch.launch_file import LaunchFile
from ..package.launch.live_text import live_text
from ..package.workspace import Workspace
from .share.joined_shares import JoinedShares
from .share.opened_elsewhere import CODE, CPP
from .share.share_references import references_folder

NAMED = (
    r"(?:\b(?:\w*LaunchConfiguration|DeclareLaunchArgument)\(\s*(?:name\s*=\s*)?|\bname=)[\"']{0}[\"']"
    r"|[\"']{0}[\"']\s*:"
)
"""An argument or an entry of that name, which is no folder."""
REACH = 200
"""The most characters of a path before the name of a folder."""


@dataclass(frozen=True)
class ShareUses:
    files: PackageFiles
    name: str
    """The package's."""
    workspace: Workspace
    absent: frozenset[str] = frozenset()
    """Folders of which nothing is installed: their files open nothing."""
    launches: tuple[LaunchFile, ...] = ()

    def opens(self, folder: str) -> bool:
        """Return whether code, a robot, a world or the README refers to a folder of the share directory."""
        return self.is_opened_by(self.code, folder)

    def is_opened_by(self, texts: Iterable[str], folder: str) -> bool:
        name = re.escape(self.name)
        started = re.compile(rf"ros2\s+launch\s+{name}\b") if folder == "launch" else None
        written = re.compile(rf"(?:package://{name}|\$\(find(?:-pkg-share)?\s+{name}\))/{re.escape(folder)}/")
        opening = (text for text in texts if written.search(text) or self.may_refer_to(text, folder))
        if not all(self.opens_nothing(text, folder) for text in opening):
            return True
        return started is not None and any(started.search(text) for text in self.readmes)

    def may_refer_to(self, text: str, folder: str) -> bool:
        """Return whether a text joins a folder to a share directory, and not only to that of another package."""
        if not references_folder(text, self.name, folder):
            return False  # what most texts end at: the search for names takes long
        text = re.sub(NAMED.format(re.escape(folder)), lambda found: " " * len(found[0]), text)
        if not references_folder(text, self.name, folder):
            return False
        return JoinedShares(text, self.name).may_join(re.compile(rf"[\"'/]{re.escape(folder)}(?=[\"'/])"))

    def makes(self, folder: str, paths: Sequence[str]) -> bool:
        """Return whether code makes a folder, which something opens, and all its files in the share directory."""
        from .paths.made_in_share import is_made_in_share  # what findings alone need

        return self.opens(folder) and is_made_in_share(self.files, self.name, folder, paths)

    def names_file(self, name: str) -> bool:
        """Return whether code or a README names a file; a path in a home folder or through src/ opens the source, and
        one in the share directory of another package a file of that."""
        named = re.compile(rf"{self.path_here}[^\s\"']*{re.escape(name)}")
        return any(named.search(text) for text in (*self.code, *self.readmes) if name in text)

    @property
    def path_here(self) -> str:
        """How a path begins that may lead to a file in the share directory of the package."""
        source = rf"/home/|~/|(?:\./)?src/|/(?:[^\s\"'/]{{1,{REACH}}}/){{0,9}}src/"
        own = re.escape(self.name)
        return rf"(?<![^\s\"'])(?!{source}|(?!{own}\))[\w-]+\)/|package://(?!{own}/))"

    def opens_nothing(self, text: str, folder: str) -> bool:
        """Return whether a text names only missing files in a folder, which other rules report."""
        named = re.findall(rf"[\"'/]{re.escape(folder)}[\"'/](?:[,\s\"'/]*([\w-][\w./-]*\.\w+)[\"'])?", text)
        return bool(named) and not any(not file or self.files.is_there(f"{folder}/{file}") for file in named)

    @property
    def code(self) -> Iterable[str]:
        return self.texts.values()

    @cached_property
    def texts(self) -> dict[str, str]:
        """The code of the package, by path."""
        paths = (path for path in self.files.paths if path.endswith(CODE) and role_of(path) not in ("test", "aside"))
        paths = (path for path in paths if path.partition("/")[0] not in self.absent)
        files = self.files
        return {path: files.readable_text(path) if path.endswith(CPP) else live_text(files, path) for path in paths}

    @cached_property
    def readmes(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.rpartition("/")[2].lower().startswith("readme"))
        return tuple(map(self.files.readable_text, paths))
