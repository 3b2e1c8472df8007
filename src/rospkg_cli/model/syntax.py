"""A Python file: its syntax tree, and the way from a node to the characters it stands on.

The parser is that of the interpreter that runs us. `ast` counts columns in UTF-8 bytes and takes a lone carriage
return for a line end; spans here are characters of the decoded text.
"""

from __future__ import annotations

import ast
import re
import sys
import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from ..source import Source, Span
from .unreadable import UnreadableError

RUNNING = sys.version_info[:2]

LINE_END = re.compile(r"\r\n|\r|\n")

NEWER = (
    ((3, 11), re.compile(r"except\s*\*|\[\s*\*\w|:\s*\*\w")),
    ((3, 12), re.compile(r"^\s*type\s+\w+|^\s*(async\s+)?(def|class)\s+\w+\s*\[|\b[rR]?[fF][rR]?[\"']")),
    ((3, 14), re.compile(r"\b[rR]?[tT][rR]?[\"']|^\s*except\b[^(:]*,|^\s*(break|continue|return)\b")),
)
"""What the grammar gained, by version: PEP 654 and 646; PEP 695 and 701; PEP 750, 758 and 765."""


class Node(Protocol):
    """What of a syntax node its span is made of."""

    lineno: int
    col_offset: int
    end_lineno: int | None
    end_col_offset: int | None


@dataclass(frozen=True)
class Syntax:
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

    def offset(self, line: int, byte: int) -> int:
        """Return the character at a line (from 1) and a column in bytes (from 0), as `ast` counts."""
        start = self.lines[line - 1]
        if self.plain:
            return start + byte
        end = self.lines[line] if line < len(self.lines) else len(self.source.text)
        return start + len(
            self.source.text[start:end].encode("utf-8", "surrogatepass")[:byte].decode("utf-8", "ignore")
        )

    def span(self, node: Node) -> Span:
        start = self.offset(node.lineno, node.col_offset)
        if node.end_lineno is None or node.end_col_offset is None:
            return Span(start, start)
        return Span(start, self.offset(node.end_lineno, node.end_col_offset))

    def text(self, node: Node) -> str:
        """Return what the node says in the file."""
        return self.source.slice(self.span(node))


def parse(source: Source) -> ast.Module:
    """Parse a file; raises UnreadableError, with `grammar` where a newer Python may well understand it."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source.text, source.path)
    except SyntaxError as error:
        raise not_python(source, error) from None
    except (RecursionError, MemoryError):
        raise UnreadableError(source.path, Span(0, 0), f"`{source.path}` is nested too deeply to be read") from None
    except ValueError as error:
        raise UnreadableError(source.path, Span(0, 0), f"`{source.path}` is not Python: {error}") from None


def not_python(source: Source, error: SyntaxError) -> UnreadableError:
    """Return the complaint at the place that Python names (its columns are characters, from 1)."""
    starts = [0, *(match.end() for match in LINE_END.finditer(source.text))]
    line = min(max(error.lineno or 1, 1), len(starts))
    start = min(starts[line - 1] + max((error.offset or 1) - 1, 0), len(source.text))
    shown = source.text[starts[line - 1] :].split("\n", 1)[0]
    newer = any(version > RUNNING and pattern.search(shown) for version, pattern in NEWER)
    message = f"`{source.path}` is not valid Python: {error.msg}"
    return UnreadableError(source.path, Span(start, min(start + 1, len(source.text))), message, grammar=newer)
