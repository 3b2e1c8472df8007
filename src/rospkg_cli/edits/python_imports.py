"""Imports in Python files: another line among those that are there."""

from __future__ import annotations

from ..finding import Edit
from ..languages.python.file import PythonFile
from ..ros.imports import STANDARD
from ..source import Span


def import_lines(file: PythonFile) -> list[tuple[str, Span]]:
    """Return the import statements at the top, as text and span."""
    found = []
    for node in file.tree.body:
        span = file.span(node)
        text = file.source.slice(span)
        if text.startswith(("import ", "from ")):
            found.append((text, span))
        elif found:
            break
    return found


def import_module(file: PythonFile, line: str) -> tuple[Edit, ...]:
    """Add an import of the standard library: among those that are there, or in a group of its own before the others.

    No edit where a file has no import at its top level, or nothing below it.
    """
    module = line.split()[1]
    found = [(text.split()[1].partition(".")[0], span) for text, span in import_lines(file)]
    standard = [(name, span) for name, span in found if name in STANDARD]
    before = [span for name, span in standard if name <= module]
    starts = file.source.line_starts
    if before:
        below = starts[file.source.position(before[-1].end)[0] :]
        return (Edit(file.path, Span(below[0], below[0]), f"{line}\n"),) if below else ()
    if not found:
        return ()
    at = (standard or found)[0][1].start
    return (Edit(file.path, Span(at, at), f"{line}\n" if standard else f"{line}\n\n"),)
