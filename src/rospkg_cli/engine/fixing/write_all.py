"""Write changes that belong together: all of them, or none; what was written is put back where another fails."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from ...fence import Fence
from ...tree import LeadsOutError, Tree, TreeEntry
from .apply import Changes
from .signals import signals_ignored, stopped_by_signals
from .write import ChangedError, WriteError, write_change


def write_all(root: Path, tree: Tree, changes: Changes, fence: Fence) -> None:
    """Write every change below a folder, or none; folders that are empty afterwards are taken away.

    `tree` holds the files as they were read. Raises WriteError where one can't be written: then nothing was.
    """
    written: list[tuple[str, TreeEntry | None]] = []
    missing = [folder for path in changes for folder in missing_folders(root, path)]
    with stopped_by_signals():
        try:
            for path, entry in sorted(changes.items()):
                written.append((path, entry_of(tree, path)))
                write_change(root / path, path, tree, entry, fence)
        except BaseException as error:
            with signals_ignored():
                put_back(root, tree, changes, written, fence)
                remove_empty(missing)
            if isinstance(error, ChangedError | LeadsOutError):
                raise WriteError(f"{error}; nothing was written") from error
            if isinstance(error, OSError):
                raise WriteError(
                    f"`{written[-1][0]}` can't be written: {error.strerror or error}; nothing was written"
                ) from error
            raise
    remove_empty([(root / path).parent for path, entry in changes.items() if entry is None])


def entry_of(tree: Tree, path: str) -> TreeEntry | None:
    """Return a file as it was read; None where there was none."""
    try:
        return tree.entry(path)
    except FileNotFoundError:
        return None


def put_back(
    root: Path, tree: Tree, changes: Changes, written: list[tuple[str, TreeEntry | None]], fence: Fence
) -> None:
    """Undo what was written, the last first; a file that somebody else changed meanwhile is left."""
    for path, before in reversed(written):
        now = WrittenFiles(tree, changes[path])
        with suppress(OSError):
            write_change(root / path, path, now, before, fence)


class WrittenFiles:
    """The tree in which one file is as it was just written."""

    def __init__(self, tree: Tree, entry: TreeEntry | None) -> None:
        self.files = tree.files
        self.sub = tree.sub
        self.written = entry

    def entry(self, path: str) -> TreeEntry:
        """Return the file that was written; raises FileNotFoundError where it was removed."""
        if self.written is None:
            raise FileNotFoundError(path)
        return self.written


def missing_folders(root: Path, path: str) -> list[Path]:
    """Return the folders that writing a path makes, the deepest first."""
    return [root / folder for folder in Path(path).parents if not (root / folder).exists()]


def remove_empty(folders: list[Path]) -> None:
    """Take folders away that hold nothing, and those above them that then hold nothing."""
    for folder in folders:
        for each in (folder, *folder.parents):
            try:
                each.rmdir()
            except OSError:
                break
