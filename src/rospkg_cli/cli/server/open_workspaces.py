"""The workspaces that an editor has open, and which of them a file belongs to."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from pygls.uris import to_fs_path

from ...engine.discovery.discover import enclosing_package
from ...engine.discovery.locate import workspace_of
from .live_workspace import LiveWorkspace
from .open_text import OpenText

TREES = ("build", "install", "log")
"""Where colcon puts what it makes."""


class OpenWorkspaces:
    """Workspaces by their folder: those of the editor, and those around packages that lie elsewhere."""

    def __init__(self) -> None:
        self.by_folder: dict[Path, LiveWorkspace] = {}
        self.texts: dict[Path, OpenText] = {}
        """All that is open, in a workspace or not."""

    def __iter__(self) -> Iterator[LiveWorkspace]:
        return iter(list(self.by_folder.values()))

    def around(self, path: Path) -> list[LiveWorkspace]:
        """Return the workspaces that a file lies in, the innermost first."""
        found = [live for folder, live in self.by_folder.items() if path.is_relative_to(folder)]
        return sorted(found, key=lambda live: len(live.folder.parts), reverse=True)

    def at(self, path: Path) -> LiveWorkspace | None:
        """Return the workspace of a file: the innermost folder of the editor around it, else that of its package."""
        if around := self.around(path):
            return around[0]
        package = enclosing_package(path.parent)
        if package is None:
            return None
        folder = workspace_of([package]) or package
        return self.by_folder.setdefault(folder, LiveWorkspace(folder))

    def shows(self, live: LiveWorkspace, path: Path) -> bool:
        """Return whether a workspace is the one that shows what is found in a file: no inner one has it."""
        around = self.around(path)
        return not around or around[0] is live

    def put(self, path: Path, text: OpenText | None) -> None:
        """Take what is in the editor, None for what is on disk, in all workspaces that see the file."""
        self.texts.pop(path, None)
        if text is not None:
            self.texts[path] = text
        package = enclosing_package(path.parent) if text and self.at(path) else None
        for live in self.around(path):
            live.put(path, text)
            live.wanted |= {package} if package else set()

    def touch(self, path: Path) -> None:
        """Note that a file has changed on disk; what git and colcon write there concerns no finding."""
        for live in self.around(path):
            if not is_written_by_tools(path, live.folder):
                live.touch(path)
                live.world.written.put(path)

    def open(self, folder: Path) -> None:
        """Add a folder of the editor; what is open in it belongs to it from now on."""
        if folder not in self.by_folder:
            self.by_folder[folder] = LiveWorkspace(folder)
            self.put_again(folder)

    def close(self, folder: Path) -> None:
        """Remove a folder of the editor; what is still open in it belongs to the next one around."""
        if live := self.by_folder.pop(folder, None):
            live.look.end()
            self.put_again(folder)

    def put_again(self, folder: Path) -> None:
        for path, text in list(self.texts.items()):
            if path.is_relative_to(folder):
                self.put(path, text)


def is_written_by_tools(path: Path, folder: Path) -> bool:
    """Return whether a path in a folder is of git's own, or in a tree that colcon has made: there, it says so.

    A build writes thousands of files, and one in no package has all packages linted anew.
    """
    inner = path.relative_to(folder)
    above = [folder / each for each in inner.parents]
    return ".git" in inner.parts[:-1] or any((each / "COLCON_IGNORE").exists() for each in above if each.name in TREES)


def path_of(uri: str) -> Path | None:
    """Return the path of a file on disk; None for what is none."""
    path = to_fs_path(uri) if uri.startswith("file:") else None
    return Path(path) if path else None
