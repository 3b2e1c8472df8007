"""The files of one package as a tree that remembers which of them were asked for."""

from __future__ import annotations

from collections.abc import Mapping

from ...disk import DiskTree
from ...disk_trace import current_trace, digest, recall
from ...light_dataclasses import dataclass, field
from ...tree import Kind, Tree, TreeEntry

Read = tuple[str, str, str]
"""A path, what was found there, and the signature of the file, "" where it must be read again."""


@dataclass
class RecordedTree:
    """A tree on disk; `reads` has what was found at each path that was asked for, there or not."""

    tree: DiskTree
    reads: dict[str, Read] = field(default_factory=dict)

    def files(self) -> Mapping[str, Kind]:
        return self.tree.files()

    def entry(self, path: str) -> TreeEntry:
        if path not in self.reads:
            self.reads[path] = found_at(self.tree, path)
        return self.tree.entry(path)

    def sub(self, folder: str) -> Tree:
        return self.tree.sub(folder)


def found_at(tree: DiskTree, path: str) -> Read:
    """Return what a tree has at a path, in few words: those of the trace, so that they are of what was really read."""
    try:
        entry = tree.entry(path)
    except (OSError, ValueError) as error:
        return path, f"{type(error).__name__} {error}", ""
    trace, question = current_trace(), f"b{tree.place(path)}"
    answer = trace.answers[question] if trace is not None else ""
    return path, f"{entry.kind} {answer}", trace.signatures[question] if trace and entry.kind == "file" else ""


def found_again(tree: DiskTree, read: Read) -> Read:
    """Return what a tree has at a path of its listing now; a file that looks as it did is not read."""
    path, answer, signature = read
    is_file = tree.files().get(path) == "file"
    if is_file and recall(tree.place(path), answer.partition(" ")[2], signature):
        return read
    return found_at(tree, path)


def listing(tree: Tree) -> str:
    """Return a digest of all paths of a tree with their kinds."""
    return digest("\0".join(f"{kind} {path}" for path, kind in tree.files().items()).encode("utf-8", "surrogatepass"))
