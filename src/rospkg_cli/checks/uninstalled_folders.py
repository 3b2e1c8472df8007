"""What happens where a folder of the share directory is not installed, and how severe that is."""

from __future__ import annotations

import re

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from .repository.pages_and_scripts import pages_and_scripts
from .share.opened_elsewhere import is_opened_elsewhere, opening_elsewhere
from .share_uses import REACH, ShareUses

EXAMPLE = regex(r"(?i)(?<![a-z])(?:examples?|samples?|templates?)(?![a-z])")
"""A word in the name of a file that people copy into a package of their own."""
LOADED = (".py", ".xml", ".yaml", ".yml", ".launch")
"""What launch may load."""
SOURCE = r"\bsrc/|(?<![\w.-])(?:/home/|/root/|/Users/|~/)|--params-file[ \t](?!\$)"
"""How a path begins that leads into a source folder or a home folder."""


@dataclass(frozen=True)
class UninstalledFolders:
    uses: ShareUses

    def opens_when_on(self, folder: str) -> bool:
        """Return whether only actions of launch files open a folder, and all of them are off by default."""
        from .launch.plain_launch import plain_texts  # what findings alone need

        others = (
            *pages_and_scripts(self.uses.files),
            *opening_elsewhere(self.uses.files, self.uses.name, self.uses.workspace),
        )
        plain = plain_texts(self.uses.launches, (*self.uses.texts.items(), *(("", text) for text in others)))
        return bool(plain) and not self.uses.is_opened_by({**self.uses.texts, **plain}.values(), folder)

    def opens_in_source(self, folder: str) -> bool:
        """Return whether the README or code opens the files of a folder in the source: `src/…/config/a.yaml`."""
        place = re.escape(folder)
        written = re.compile(rf"(?:{SOURCE})(?![^\s`\"']*/share/)[^\s`]{{0,{REACH}}}\b{place}/")
        if any(written.search(text) for text in (*self.uses.readmes, *self.uses.code)):
            return True
        from .repository.started_by_place import is_started_by_place  # what findings alone need

        return folder == "launch" and is_started_by_place(self.uses.files, self.uses.name, folder)

    def is_opened_in_source_elsewhere(self, folder: str) -> bool:
        """Return whether another package has a path into the folder in the source: `/home/…/src/my_pkg/maps/`."""
        place = f"{re.escape(self.uses.files.folder.rpartition('/')[2] or self.uses.name)}/{re.escape(folder)}"
        written = re.compile(rf"(?:{SOURCE})(?![^\s`\"']*/share/)[^\s`\"']{{0,{REACH}}}(?<![\w.-]){place}/")
        return any(
            written.search(text) for text in opening_elsewhere(self.uses.files, self.uses.name, self.uses.workspace)
        )

    def level(self, folder: str) -> str | None:
        """Return `error` where the package opens a folder, `info` where nothing seems to, and None in other cases.

        A missing config is no error for RViz, which starts with its default view.
        """
        if self.uses.opens(folder):
            if self.is_put_there(folder) or (self.opens_when_on(folder) and not self.may_be_opened(folder)):
                return "info"
            return None if folder == "rviz" else "error"
        is_left = folder != "launch" or self.holds_examples(folder) or self.is_stopped(folder)
        needed = not is_left or self.may_be_opened(folder)
        return None if needed and not (self.opens_in_source(folder) or self.is_put_there(folder)) else "info"

    def is_put_there(self, folder: str) -> bool:
        """Return whether only a script or a page puts a folder into the share directory."""
        from .repository.put_in_share import is_put_in_share  # what findings alone need

        return is_put_in_share(self.uses.files, self.uses.name, folder)

    def holds_examples(self, folder: str) -> bool:
        """Return whether all files of a folder are examples by their names."""
        return all(EXAMPLE.search(path.rpartition("/")[2]) for path in self.uses.files.below(folder))

    def is_stopped(self, folder: str) -> bool:
        """Return whether launch can load no file of a folder, as each has a keyword of nodes that Foxy was the last to
        have.
        """
        from .launch.stopped_launches import are_all_stopped  # what findings alone need

        paths = (path for path in self.uses.files.below(folder) if path.endswith(LOADED) and "__init__" not in path)
        return are_all_stopped(paths, self.uses.launches, self.uses.files)

    def may_be_opened(self, folder: str) -> bool:
        """Return whether another package of the workspace opens the folder or a file in it.

        Configs of RViz do not count, as it starts without them.
        """
        paths = [path for path in self.uses.files.below(folder) if not path.endswith(".rviz")]
        return bool(paths) and is_opened_elsewhere(folder, paths, self.uses.files, self.uses.name, self.uses.workspace)

    def consequence(self, folder: str) -> str:
        """Return what happens where a folder is not installed, for a message."""
        if self.is_put_there(folder):
            return "only a script or a page puts it into the share directory, and the build does not"
        if folder == "launch" and not self.opens_in_source(folder):
            nor = ", nor could launch load it today" if self.is_stopped(folder) else ""
            return f"`ros2 launch {self.uses.name} …` does not find it{nor}"
        if self.level(folder) != "info":
            return "what opens it in the share directory does not find it"
        if self.opens_in_source(folder):
            return "only its README or code opens it, in the source folder, which an installed package lacks"
        if self.uses.opens(folder):
            return "what opens it in the share directory is off by default, and does not find it"
        if self.is_opened_in_source_elsewhere(folder):
            return "only another package opens it, in the source folder, which an installed package lacks"
        return "nothing in this package or another seems to open it"
