"""Whether a package opens a folder in its share directory, or its README does so in the source folder."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.launch.launch_file import LaunchFile
from ..package.launch.live_text import live_text
from ..package.workspace import Workspace
from .repository.pages_and_scripts import pages_and_scripts
from .share.joined_shares import JoinedShares
from .share.opened_elsewhere import CODE, CPP, is_opened_elsewhere, opening_elsewhere
from .share.share_references import references_folder

EXAMPLE = regex(r"(?i)(?<![a-z])(?:examples?|samples?|templates?)(?![a-z])")
"""A word in the name of a file that people copy into a package of their own."""
NAMED = (
    r"(?:\b(?:\w*LaunchConfiguration|DeclareLaunchArgument)\(\s*(?:name\s*=\s*)?|\bname=)[\"']{0}[\"']"
    r"|[\"']{0}[\"']\s*:"
)
"""An argument or an entry that has a name: of no folder."""
LOADED = (".py", ".xml", ".yaml", ".yml", ".launch")
"""What launch may load."""
SOURCE = r"\bsrc/|(?<![\w.-])(?:/home/|/root/|/Users/|~/)|--params-file[ \t](?!\$)"
"""How a path begins that leads into a source folder or somebody's home."""
REACH = 200
"""The most characters of a path before the name of a folder."""


@dataclass(frozen=True)
class ShareUses:
    files: PackageFiles
    name: str
    """The package's."""
    workspace: Workspace
    absent: frozenset[str] = frozenset()
    """Folders of which nothing is installed: what lies in them opens nothing."""
    launches: tuple[LaunchFile, ...] = ()

    def opens(self, folder: str) -> bool:
        """Return whether code, a robot, a world or the README refers to a folder of the share directory."""
        return self.is_opened_by(self.code, folder)

    def opens_when_on(self, folder: str) -> bool:
        """Return whether only actions of launch files open a folder that are off by default."""
        from .launch.plain_launch import plain_texts  # what findings alone need

        others = (*pages_and_scripts(self.files), *opening_elsewhere(self.files, self.name, self.workspace))
        plain = plain_texts(self.launches, (*self.texts.items(), *(("", text) for text in others)))
        return bool(plain) and not self.is_opened_by({**self.texts, **plain}.values(), folder)

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
        """Return whether code makes a folder in the share directory that some text opens, and all files in it."""
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
        """Return whether a text names nothing but files in a folder that are not there: those are faults of its own."""
        named = re.findall(rf"[\"'/]{re.escape(folder)}[\"'/](?:[,\s\"'/]*([\w-][\w./-]*\.\w+)[\"'])?", text)
        return bool(named) and not any(not file or self.files.is_there(f"{folder}/{file}") for file in named)

    def opens_in_source(self, folder: str) -> bool:
        """Return whether the README or code opens the folder's files where they lie: `src/…/config/a.yaml`."""
        place = re.escape(folder)
        written = re.compile(rf"(?:{SOURCE})(?![^\s`\"']*/share/)[^\s`]{{0,{REACH}}}\b{place}/")
        if any(written.search(text) for text in (*self.readmes, *self.code)):
            return True
        from .repository.started_by_place import is_started_by_place  # what findings alone need

        return folder == "launch" and is_started_by_place(self.files, self.name, folder)

    def is_opened_in_source_elsewhere(self, folder: str) -> bool:
        """Return whether another package has a path into the folder where it lies: `/home/…/src/my_pkg/maps/`."""
        place = f"{re.escape(self.files.folder.rpartition('/')[2] or self.name)}/{re.escape(folder)}"
        written = re.compile(rf"(?:{SOURCE})(?![^\s`\"']*/share/)[^\s`\"']{{0,{REACH}}}(?<![\w.-]){place}/")
        return any(written.search(text) for text in opening_elsewhere(self.files, self.name, self.workspace))

    @property
    def code(self) -> Iterable[str]:
        return self.texts.values()

    @cached_property
    def texts(self) -> dict[str, str]:
        """By path, what the code of the package says."""
        paths = (path for path in self.files.paths if path.endswith(CODE) and role_of(path) not in ("test", "aside"))
        paths = (path for path in paths if path.partition("/")[0] not in self.absent)
        files = self.files
        return {path: files.readable_text(path) if path.endswith(CPP) else live_text(files, path) for path in paths}

    @cached_property
    def readmes(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.rpartition("/")[2].lower().startswith("readme"))
        return tuple(map(self.files.readable_text, paths))

    def level(self, folder: str) -> str | None:
        """Return `error` where the package opens a folder, `info` where nothing seems to; None between them.

        RViz starts with its default view where its config is missing.
        """
        if self.opens(folder):
            if self.is_put_there(folder) or (self.opens_when_on(folder) and not self.may_be_opened(folder)):
                return "info"
            return None if folder == "rviz" else "error"
        is_left = folder != "launch" or self.holds_examples(folder) or self.is_stopped(folder)
        needed = not is_left or self.may_be_opened(folder)
        return None if needed and not (self.opens_in_source(folder) or self.is_put_there(folder)) else "info"

    def is_put_there(self, folder: str) -> bool:
        from .repository.put_in_share import is_put_in_share  # what findings alone need

        return is_put_in_share(self.files, self.name, folder)

    def holds_examples(self, folder: str) -> bool:
        return all(EXAMPLE.search(path.rpartition("/")[2]) for path in self.files.below(folder))

    def is_stopped(self, folder: str) -> bool:
        """Return whether launch can load no file of a folder: each has a keyword of a node that Foxy was the last to
        take.
        """
        from .launch.stopped_launches import are_all_stopped  # what findings alone need

        paths = (path for path in self.files.below(folder) if path.endswith(LOADED) and "__init__" not in path)
        return are_all_stopped(paths, self.launches, self.files)

    def may_be_opened(self, folder: str) -> bool:
        """Return whether another package of the workspace opens the folder or a file in it.

        RViz goes on without its config.
        """
        paths = [path for path in self.files.below(folder) if not path.endswith(".rviz")]
        return bool(paths) and is_opened_elsewhere(folder, paths, self.files, self.name, self.workspace)

    def consequence(self, folder: str) -> str:
        """Return what happens where a folder is not installed, for a message."""
        if self.is_put_there(folder):
            return "only a script or a page puts it into the share directory, and the build does not"
        if folder == "launch" and not self.opens_in_source(folder):
            nor = ", nor could launch load it today" if self.is_stopped(folder) else ""
            return f"`ros2 launch {self.name} …` does not find it{nor}"
        if self.level(folder) != "info":
            return "what opens it in the share directory does not find it"
        if self.opens_in_source(folder):
            return "only its README or code opens it, in the source folder, which an installed package lacks"
        if self.opens(folder):
            return "what opens it in the share directory is off by default, and does not find it"
        if self.is_opened_in_source_elsewhere(folder):
            return "only another package opens it, in the source folder, which an installed package lacks"
        return "nothing in this package or another seems to open it"
