"""Fixes as an editor makes them: edits of open and closed files, new files, moved and removed ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from difflib import SequenceMatcher

from lsprotocol import types

from ...encoding import DecodedText
from ...engine.fixing.apply import Changes
from ...finding import Chmod, Create, Delete, Edit, Fix, Move, Operation
from ...source import Source, Span
from .linted import Linted
from .positions import span_range

Change = types.TextDocumentEdit | types.CreateFile | types.RenameFile | types.DeleteFile


def is_possible(fix: Fix) -> bool:
    """Return whether an editor can make a fix: none of them sets the mode of a file."""
    return not any(isinstance(each, Chmod) or (isinstance(each, Create) and each.executable) for each in fix.operations)


def workspace_edit(operations: Iterable[Operation], linted: Linted) -> types.WorkspaceEdit:
    """Return operations on files below the root of a run as one edit."""
    edits: dict[str, list[types.TextEdit | types.AnnotatedTextEdit | types.SnippetTextEdit]] = {}
    changes: list[Change] = []
    for each in operations:
        if isinstance(each, Edit):
            at = span_range(linted.codec, linted.source(each.path), each.span.start, each.span.end)
            edits.setdefault(each.path, []).append(types.TextEdit(at, each.text))
        else:
            changes += file_changes(each, linted)
    changes += [document_edit(linted.uri(path), found, linted.version(path)) for path, found in edits.items()]
    return types.WorkspaceEdit(document_changes=changes)


def file_changes(operation: Operation, linted: Linted) -> Iterator[Change]:
    """Yield what makes, moves or removes a file."""
    if isinstance(operation, Create):
        yield types.CreateFile(linted.uri(operation.path))
        yield document_edit(linted.uri(operation.path), [types.TextEdit(START, operation.text)])
    elif isinstance(operation, Delete):
        yield types.DeleteFile(linted.uri(operation.path))
    elif isinstance(operation, Move):
        yield types.RenameFile(linted.uri(operation.path), linted.uri(operation.to))


START = types.Range(types.Position(0, 0), types.Position(0, 0))


def document_edit(
    uri: str, edits: list[types.TextEdit | types.AnnotatedTextEdit | types.SnippetTextEdit], version: int | None = None
) -> types.TextDocumentEdit:
    return types.TextDocumentEdit(types.OptionalVersionedTextDocumentIdentifier(uri, version), edits)


def edit_of_changes(changes: Changes, linted: Linted) -> types.WorkspaceEdit:
    """Return what makes files what they are to be, by the lines that differ."""
    operations: list[Operation] = []
    for path, entry in changes.items():
        is_there = path in linted.session.tree.files()
        if entry is None:
            operations.append(Delete(path))
        elif not is_there:
            operations.append(Create(path, entry.text.text))
        else:
            operations += line_edits(linted.source(path), entry.text)
    return workspace_edit(operations, linted)


def line_edits(before: Source, after: DecodedText) -> Iterator[Edit]:
    """Yield the edits, line by line, that make one text of another."""
    old, new = before.text.splitlines(keepends=True), after.text.splitlines(keepends=True)
    starts = [0]
    for line in old:
        starts.append(starts[-1] + len(line))
    for tag, a, b, c, d in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if tag != "equal":
            yield Edit(before.path, Span(starts[a], starts[b]), "".join(new[c:d]))
