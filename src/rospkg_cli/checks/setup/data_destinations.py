"""Rule input: destinations of data_files where no tool looks for files."""

from __future__ import annotations

import posixpath
from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.launch_file import LaunchFile
from ...package.setup.data_files import DataEntry, DataFile
from ...ros.share_layout import FOLDERS, LAUNCH, SHARED
from ...suggest import near_names
from ...unreadable import READABLE
from ..launch.idle_actions import level_at
from .share_files import ShareFiles


@dataclass(frozen=True)
class DataDestinations:
    shared: ShareFiles
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def included(self, entry: DataEntry) -> tuple[str, str] | None:
        """Return the launch file of the package that stops at a file which an entry installs, and that file."""
        asked = {("include", self.shared.package.name, file.source) for file in entry.files}
        for file in self.launch_files:
            for each in file.paths if role_of(file.path) == "launch" and not file.is_ros1 else ():
                if (each.use, each.package, each.path) in asked and level_at(file, each.span)[0] is None:
                    return file.path, each.path
        return None

    def why_unmet(self, entry: DataEntry) -> str:
        """Return why nothing is known to need the files of an entry at their right place; "" where something is.

        Launch files and package.xml are looked for by ROS itself, other files by what opens them.
        """
        files = [file.source for file in entry.files if file.source]
        there = {file.source for file in self.shared.package.setup.data_files if self.is_right(file)}
        lost = [path for path in files if path not in there]
        if files and not lost:
            return "another entry installs its files where they are looked for"
        manifest = self.shared.package.files.readable_text("package.xml")  # it names descriptions of plugins
        if any(
            is_for_ros(path) or posixpath.basename(path) in manifest or self.shared.opened.opens(path) for path in lost
        ):
            return ""
        folders = {posixpath.dirname(path) for path in lost} - {""}
        return "" if any(map(self.shared.opened.opens_folder, folders)) else "nothing here opens its files there"

    def is_right(self, file: DataFile) -> bool:
        """Return whether a file goes into the share directory of the package."""
        return any(file.destination.startswith(f"share/{name}/") for name in self.shared.names)

    @cached_property
    def misplaced(self) -> tuple[tuple[DataEntry, str, str], ...]:
        """Entries with a wrong destination: the entry, the right destination, and the reason."""
        found = []
        for entry in self.shared.package.setup.data_entries:
            if entry.destination is None or not entry.files:
                continue
            text, (first, *rest) = entry.destination.text, entry.folder.strip("/").split("/")
            if text.startswith("/"):
                why = "begins with a slash: colcon stops, the destination is relative to the install prefix"
                found.append((entry, entry.folder.strip("/"), why))
            elif first == "share" and rest and rest[0] not in self.shared.names | SHARED:
                own = rest if rest[0] in FOLDERS else rest[1:]
                why = f"is not the share folder of `{self.shared.package.name}`, where its files are looked for"
                found.append((entry, "/".join(("share", self.shared.package.name, *own)), why))
            elif first in self.shared.names or first in FOLDERS:
                own = [first, *rest] if first in FOLDERS else rest
                why = "is a folder right below the install prefix, where nothing is looked for"
                found.append((entry, "/".join(("share", self.shared.package.name, *own)), why))
            elif rest[:1] == [self.shared.package.name] and near_names(first, ["share"]):
                why = "is below no folder that anything searches (did you mean `share`?)"
                found.append((entry, "/".join(("share", *rest)), why))
        return tuple(found)


def is_for_ros(path: str) -> bool:
    """Return whether ROS itself looks for a file: a manifest, or a launch file."""
    name = posixpath.basename(path)
    return name == "package.xml" or role_of(path) == "launch" or LAUNCH.fullmatch(name) is not None
