"""Whether anything in a workspace opens a file in the share directory of a package, or starts it there."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..ros.share_layout import LAUNCH
from .repository.pages_and_scripts import pages_and_scripts
from .share.joined_shares import JoinedShares
from .share.opened_elsewhere import live, opening, opening_elsewhere
from .share_uses import ShareUses

MARKUP = (".urdf", ".xacro", ".sdf", ".world", ".xml")
"""Files that name others by paths relative to themselves."""
IMAGE = r"(?m:^[ \t]*image[ \t]*:[ \t]*)[\"']?"
"""What precedes the image of a map in its YAML file, which names it by a relative path."""


@dataclass(frozen=True)
class OpenedInShare:
    uses: ShareUses

    def opens(self, path: str) -> bool:
        """Return whether something opens a file, by its path in the package, or starts it."""
        name = posixpath.basename(path)
        if LAUNCH.fullmatch(name) and (self.is_started(name) or self.is_included(path, name)):
            return True
        word = rf"{re.escape(name)}(?![\w.-])"
        texts = (text for own, text in self.texts if own != path and name in text)
        return any(self.shares_of(text).join(word) for text in texts) or self.is_named_relatively(path, name)

    def opens_folder(self, folder: str) -> bool:
        """Return whether a folder is opened as a whole; the name of a file behind it opens that file."""
        name = re.escape(posixpath.basename(folder))
        word = rf"{name}(?:/?[\"'](?![\s,/+(]*f?[\"'][\w./-]*\.\w+[\"'])|/[{{$])"
        is_model = re.compile(rf"model://{name}[\"'/<]")
        return any(
            is_model.search(text) or self.shares_of(text).join(word)
            for _, text in self.texts
            if posixpath.basename(folder) in text
        )

    def is_started(self, name: str) -> bool:
        """Return whether a page or a script starts a launch file with `ros2 launch`, behind the package's name."""
        starts = re.compile(rf"\bros2\s+launch\s+(?:-\S+\s+)*{re.escape(self.uses.name)}\s+{re.escape(name)}(?![\w-])")
        return any(starts.search(text) for text in (*pages_and_scripts(self.uses.files), *self.uses.readmes))

    def is_included(self, path: str, name: str) -> bool:
        """Return whether another launch file of the package names this one, and in no other package's share."""
        word = re.compile(rf"{self.uses.path_here}[^\s\"']*{re.escape(name)}")
        launches = (text for own, text in self.texts if own != path and (role_of(own) == "launch" if own else False))
        return any(self.shares_of(text).may_join(word) for text in launches if name in text)

    def is_named_relatively(self, path: str, name: str) -> bool:
        """Return whether a robot, a world or a map names a file by a path relative to itself."""
        relative = re.compile(rf"(?:[\"'>]|{IMAGE})([\w./-]*{re.escape(name)})(?![\w.-])")
        own = ((each, text) for each, text in self.texts if each.endswith((*MARKUP, ".yaml", ".yml")) and name in text)
        places = (
            posixpath.normpath(posixpath.join(posixpath.dirname(each), found[1]))
            for each, text in own
            if each != path and role_of(each) != "launch"
            for found in relative.finditer(text)
            if each.endswith(MARKUP) or found[0].lstrip().startswith("image")
        )
        return path in places

    def shares_of(self, text: str) -> JoinedShares:
        return JoinedShares(text, self.uses.name)

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """What opens files, without comments, each with its path in this package; "" in another one."""
        own = ((path, live(self.uses.files, path)) for path in opening(self.uses.files.paths))
        return (*own, *(("", text) for text in opening_elsewhere(self.uses.files, self.uses.name, self.uses.workspace)))
