"""A Python file: its syntax tree, and the spans of its nodes in characters.

The parser is that of the running Python. `ast` counts columns in UTF-8 bytes and takes a lone carriage
return for a line end; spans here are characters of the decoded text.
"""

from __future__ import annotations

import ast
import gc
import warnings
from functools import cached_property
from typing import Protocol

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from ..char_table import CharTable
from .compile_errors import compile_error
from .size_limits import MAX_DEPTH, MAX_TOKENS, is_too_deep, is_too_large

LINE_END = regex(r"\r\n|\r|\n")


class PositionedNode(Protocol):
    """The attributes of a syntax node that give its span."""

    @property
    def lineno(self) -> int: ...
    @property
    def col_offset(self) -> int: ...
    @property
    def end_lineno(self) -> int | None: ...
    @property
    def end_col_offset(self) -> int | None: ...


@dataclass(frozen=True)
class PythonSyntax:
    """The syntax tree of one file."""

    source: Source
    tree: ast.Module

    @property
    def path(self) -> str:
        return self.source.path

    @cached_property
    def lines(self) -> list[int]:
        """The offset of each line's first character, as Python counts lines."""
        return [0, *(match.end() for match in LINE_END.finditer(self.source.text))]

    @cached_property
    def plain(self) -> bool:
        """Whether a byte is a character throughout."""
        return self.source.text.isascii()

    @cached_property
    def columns(self) -> dict[int, CharTable | None]:
        """By line, for each byte the character that it belongs to; None for a line of which each byte is one."""
        return {}

    def offset(self, line: int, byte: int) -> int:
        """Return the character at a line (from 1) and a column in bytes (from 0), as `ast` counts."""
        start = self.lines[line - 1]
        if self.plain:
            return start + byte
        if line not in self.columns:
            text = self.source.text[start : self.lines[line] if line < len(self.lines) else len(self.source.text)]
            self.columns[line] = None if text.isascii() else CharTable(text)
        columns = self.columns[line]
        return start + (byte if columns is None else columns[byte])

    def span(self, node: PositionedNode) -> Span:
        if node.end_lineno is None or node.end_col_offset is None:
            start = self.offset(node.lineno, node.col_offset)
            return Span(start, start)
        if self.plain:
            lines = self.lines
            return Span(lines[node.lineno - 1] + node.col_offset, lines[node.end_lineno - 1] + node.end_col_offset)
        start = self.offset(node.lineno, node.col_offset)
        return Span(start, self.offset(node.end_lineno, node.end_col_offset))

    def text(self, node: PositionedNode) -> str:
        """Return the text of a node."""
        return self.source.slice(self.span(node))


def parse(source: Source) -> ast.Module:
    """Parse a file; raises UnreadableError, with `grammar` where a newer Python will understand it.

    With `skipped` where it is too large, or nested too deeply, for what visits the tree.
    """
    if is_too_large(source.text):
        raise skipped_file(source, ReadProblem.PYTHON_LENGTH, f"{MAX_TOKENS:,}")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = parsed_without_collector(source)
    except SyntaxError as error:
        raise syntax_error(source, error) from None
    except (RecursionError, MemoryError):
        raise UnreadableError(source.path, Span(0, 0), ReadProblem.PYTHON_TOO_DEEP) from None
    except ValueError as error:
        raise UnreadableError(source.path, Span(0, 0), ReadProblem.PYTHON_VALUE, str(error)) from None
    if is_too_deep(tree):
        raise skipped_file(source, ReadProblem.PYTHON_DEPTH, str(MAX_DEPTH))
    refused = compile_error(source, tree)
    if refused is not None:
        raise refused_by_compiler(source, refused)
    return tree


def parsed_without_collector(source: Source) -> ast.Module:
    """Parse while the garbage collector rests: all of a tree is alive, and looking through it takes twice the time."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        return ast.parse(source.text, source.path)
    finally:
        if was_enabled:
            gc.enable()


def skipped_file(source: Source, code: ReadProblem, most: str) -> UnreadableError:
    return UnreadableError(source.path, Span(0, 0), code, most, skipped=True)


def syntax_error(source: Source, error: SyntaxError) -> UnreadableError:
    """Return the error at the position that Python reports (its columns are characters, from 1)."""
    from .newer_syntax import needs_newer  # few files have an error: most runs do without it

    start, is_newer = line_start(source, error) + max((error.offset or 1) - 1, 0), needs_newer(source.text)
    return UnreadableError(
        source.path, character(source, start), ReadProblem.PYTHON_SYNTAX, str(error.msg), grammar=is_newer
    )


def refused_by_compiler(source: Source, error: SyntaxError) -> UnreadableError:
    """Return the error of Python's compiler, which counts columns in bytes; no newer Python takes what it refuses."""
    start = line_start(source, error)
    before = source.text[start:].encode()[: max((error.offset or 1) - 1, 0)].decode(errors="ignore")
    return UnreadableError(
        source.path, character(source, start + len(before)), ReadProblem.PYTHON_SYNTAX, str(error.msg)
    )


def line_start(source: Source, error: SyntaxError) -> int:
    starts = [0, *(match.end() for match in LINE_END.finditer(source.text))]
    return starts[min(max(error.lineno or 1, 1), len(starts)) - 1]


def character(source: Source, start: int) -> Span:
    """Return the character at an offset; nothing at the end of the text."""
    first = min(start, len(source.text))
    return Span(first, min(first + 1, len(source.text)))
