"""The texts of an editor over the files on disk."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from ...disk import DiskTree
from ...engine.fixing.overlay import Overlay
from ...light_dataclasses import replace
from ...tree import TreeEntry
from .open_text import OpenText


def overlay(tree: DiskTree, root: Path, texts: Mapping[Path, OpenText]) -> Overlay:
    """Return a tree below a root with the texts of an editor over it."""
    inside = {path.relative_to(root).as_posix(): text for path, text in texts.items() if path.is_relative_to(root)}
    return Overlay(tree, {path: with_text(tree, path, text.data) for path, text in inside.items()})


def with_text(tree: DiskTree, path: str, text: bytes) -> TreeEntry:
    """Return a file with the text of an editor; its mode is that on disk."""
    try:
        return replace(tree.entry(path), data=text, skipped="")
    except OSError:
        return TreeEntry("file", text)


def package_of(path: Path, root: Path, folders: Iterable[str]) -> str | None:
    """Return the innermost of some folders (from the root) that holds a path; None where none does."""
    if not path.is_relative_to(root):
        return None
    inner = path.relative_to(root).as_posix() + "/"
    found = [each for each in folders if not each or inner.startswith(f"{each}/")]
    return max(found, key=len, default=None)
