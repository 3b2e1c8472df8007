"""Apply the operations of fixes to a tree in memory: equal operations once, whatever else touches waits."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable, Sequence
from itertools import groupby

from ...edits.dependency_lines import in_order
from ...finding import Chmod, Create, Delete, Edit, Fix, Move, Operation
from ...light_dataclasses import dataclass, field
from ...source import Span
from ...tree import Tree, TreeEntry

Changes = dict[str, TreeEntry | None]
"""Path to its new entry; None where the file is gone."""


@dataclass
class Round:
    """The operations that are applied together."""

    _chosen: set[Operation] = field(default_factory=set)
    edits: dict[str, list[Edit]] = field(default_factory=dict)
    _spans: dict[str, list[Span]] = field(default_factory=dict)
    """Of the edits of each file, sorted."""
    whole: dict[str, Operation] = field(default_factory=dict)
    """Files that an operation other than an edit claims."""

    def take(self, fix: Fix) -> bool:
        """Add a fix if nothing in it touches what was taken before; equal operations count once."""
        fresh = [operation for operation in fix.operations if operation not in self._chosen]
        if any(self.clashes(operation) for operation in fresh):
            return False
        for operation in fresh:
            self._chosen.add(operation)
            if isinstance(operation, Edit):
                self.edits.setdefault(operation.path, []).append(operation)
                insort(self._spans.setdefault(operation.path, []), operation.span)
            else:
                self.whole |= dict.fromkeys(paths_of(operation), operation)
        return True

    def clashes(self, operation: Operation) -> bool:
        if any(path in self.whole for path in paths_of(operation)):
            return True
        if isinstance(operation, Edit):
            spans = self._spans.get(operation.path, [])
            at = bisect_left(spans, operation.span)  # none of them touch each other: the neighbours are enough
            return any(touch(operation.span, span) for span in spans[max(at - 1, 0) : at + 1])
        return any(path in self.edits for path in paths_of(operation))


def paths_of(operation: Operation) -> tuple[str, ...]:
    return (operation.path, operation.to) if isinstance(operation, Move) else (operation.path,)


def touch(a: Span, b: Span) -> bool:
    """Return whether two edits get in each other's way; two insertions at one place do not."""
    if a.start == a.end and b.start == b.end:
        return False
    return a.start <= b.end and b.start <= a.end


def apply_round(tree: Tree, round_: Round) -> Changes:
    """Return what the operations make of the files they touch; raises UnicodeError, FileNotFoundError."""
    changes: Changes = {}
    for path, edits in round_.edits.items():
        changes[path] = edited(tree.entry(path), edits)
    for operation in dict.fromkeys(round_.whole.values()):
        changes |= outcome(tree, operation)
    return changes


def edited(entry: TreeEntry, edits: Sequence[Edit]) -> TreeEntry:
    """Return the entry with the edits made, in the encoding and line ends that it had."""
    text = entry.text.text
    pieces: list[str] = []
    at = 0
    for span, together in groupby(sorted(edits, key=lambda e: e.span), lambda e: e.span):
        texts = [each.text for each in together]
        pieces += [text[at : span.start], together_at(edits[0].path, texts) if len(texts) > 1 else texts[0]]
        at = span.end
    return TreeEntry(entry.kind, entry.text.encode("".join([*pieces, text[at:]])), entry.mode)


def together_at(path: str, texts: Sequence[str]) -> str:
    """Return what is put in at one place of a file as one text."""
    name = path.rpartition("/")[2]
    if name == "package.xml":
        return in_order(texts)
    joined = "".join(texts)
    return joined.replace("\n\n\n", "\n\n") if name.endswith((".txt", ".cmake")) else joined


def outcome(tree: Tree, operation: Operation) -> Changes:
    match operation:
        case Create(path, text, executable):
            return {path: TreeEntry("file", text.encode(), 0o755 if executable else 0o644)}
        case Delete(path):
            return {path: None}
        case Move(path, to):
            return {path: None, to: tree.entry(path)}
        case Chmod(path, executable):
            entry = tree.entry(path)
            bits = (entry.mode & 0o444) >> 2
            return {path: TreeEntry(entry.kind, entry.data, entry.mode | bits if executable else entry.mode & ~0o111)}
        case _:
            raise TypeError(f"{type(operation).__name__} is not an operation on a whole file")


def apply_fixes(tree: Tree, fixes: Iterable[Fix]) -> tuple[Changes, list[Fix]]:
    """Apply as many fixes as fit together, in order; return the changes and the fixes that were taken."""
    round_, taken = Round(), []
    for fix in fixes:
        if round_.take(fix):
            taken.append(fix)
    return apply_round(tree, round_), taken
