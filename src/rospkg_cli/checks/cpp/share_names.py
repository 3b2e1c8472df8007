"""Packages whose share directory or prefix C++ looks for by a literal name."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...source import Span

LOOKUP = regex(r"\bget_package_(?:share_directory|share_path|prefix)\s*\(")
NAME = regex(r'\s*"([A-Za-z]\w*)"\s*\)')
CAUGHT = "PackageNotFoundError"
TRY = regex(r"\btry\s*\{")
BRACE = regex(r"[{}]")
CATCHES = regex(r"\s*catch\s*\(\s*(?:\.\.\.|[^)]{0,80}\b(?:exception|runtime_error)\b)")
"""What takes the exception of a package that is not there, which is a `std::runtime_error`."""


def share_names(file: CppFile) -> Iterator[tuple[str, Span]]:
    """Yield each name with its place between the quotes; none where code catches that a package is not there."""
    yield from ((name, span) for name, span, is_caught in all_share_names(file) if not is_caught)


def all_share_names(file: CppFile) -> Iterator[tuple[str, Span, bool]]:
    """Yield each name with its place, and whether code catches that a package is not there."""
    text = file.source.text
    if "get_package_" not in text:
        return  # before the comments are found, which takes longer
    code = code_text(text)
    guarded = [Span(0, len(code))] if CAUGHT in text else [*guarded_blocks(code)]
    for call in LOOKUP.finditer(code):
        if found := NAME.match(text, call.end()):
            span = Span(*found.span(1))
            yield found[1], span, any(each.holds(span) for each in guarded)


def guarded_blocks(code: str) -> Iterator[Span]:
    """Yield the blocks behind `try` whose first `catch` takes that exception."""
    for start in TRY.finditer(code):
        depth = 1
        for brace in BRACE.finditer(code, start.end()):
            depth += 1 if brace[0] == "{" else -1
            if depth == 0:
                if CATCHES.match(code, brace.end()):
                    yield Span(start.end(), brace.start())
                break
