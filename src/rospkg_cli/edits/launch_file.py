"""Edits of Python launch files."""

from __future__ import annotations

import ast
import re
from itertools import pairwise

from ..finding import Edit
from ..languages.python.file import PythonFile
from ..lazy_regex import regex
from ..source import Span
from .python_list import deeper

STRINGS = regex(r"'[^'\n]*'|\"[^\"\n]*\"|#.*")
CLOSING = regex(r"([)\]}]+),?[ \t\r]*")


def import_name(file: PythonFile, module: str, name: str) -> tuple[Edit, ...]:
    """Import a name, by the order of the modules among those of its top package, or else among all.

    Nothing where the file has the name.
    """
    if name in file.definitions:
        return ()
    every = [node for node in file.tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    top = module.partition(".")[0]
    alike = [node for node in every if module_of(node).partition(".")[0] == top] or every
    before = [node for node in alike if module_of(node) < module or module_of(node) == "__future__"]
    text, line = file.source.text, f"from {module} import {name}"
    newline = "\r\n" if "\r\n" in text else "\n"
    if not before:
        start = file.span(alike[0]).start if alike else 0
        return (Edit(file.path, Span(start, start), line + newline),)
    end = text.find("\n", file.span(before[-1]).end)
    at = len(text) if end == -1 else end + 1
    return (Edit(file.path, Span(at, at), newline + line if end == -1 else line + newline),)


def module_of(node: ast.Import | ast.ImportFrom) -> str:
    return node.module or "" if isinstance(node, ast.ImportFrom) else node.names[0].name


def pass_through(file: PythonFile, span: Span, call: str, last: str, width: int) -> tuple[Edit, ...]:
    """Write a call with one more argument around an expression, over several lines where one would be too long.

    Where closing brackets stand in lines of their own, those of the call do so too, and the outermost brackets of the
    line are opened first, as black does. Nothing where a line would be too long in every way.
    """
    text = file.source.text
    start = text.rfind("\n", 0, span.start) + 1
    end = text.find("\n", span.end)
    line = Span(start, end if end != -1 else len(text))
    indent = text[start : len(text) - len(text[start:].lstrip(" \t"))]
    newline = "\r\n" if "\r\n" in text else "\n"
    inner, outer = f"{newline}{deeper(indent)}", f"{newline}{indent}"
    ways: list[tuple[tuple[int, str], ...]] = [((span.start, f"{call}("), (span.end, f", {last})"))]
    if closes_alone(text):
        brackets = outermost(text, line, span)
        ways += [((brackets.start, inner), *ways[0], (brackets.end, outer))] if brackets else []
        ways.append(((span.start, f"{call}({inner}"), (span.end, f", {last}{outer})")))
    ways.append(((span.start, f"{call}({inner}"), (span.end, f",{inner}{last})")))
    for way in ways:
        made: dict[int, str] = {}
        for at, code in way:
            made[at] = made.get(at, "") + code
        if all(len(each.rstrip()) <= width for each in written(text, line, made).split("\n")):
            return tuple(Edit(file.path, Span(at, at), code) for at, code in made.items())
    return ()


def written(text: str, line: Span, insertions: dict[int, str]) -> str:
    """Return a line with some insertions."""
    places = sorted({line.start, line.end, *insertions})
    return "".join(insertions.get(at, "") + text[at:to] for at, to in pairwise([*places, line.end]))


def closes_alone(text: str) -> bool:
    """Return whether most brackets over several lines close in a line of their own."""
    alone = others = 0
    for line in STRINGS.sub("", text).splitlines():
        is_alone = line.lstrip().startswith((")", "]", "}"))
        alone += is_alone
        others += not is_alone and sum(map(line.count, ")]}")) > sum(map(line.count, "([{"))
    return alone > others


def outermost(text: str, line: Span, span: Span) -> Span | None:
    """Return what the outermost brackets around a span in its line hold; None where they are not alone there."""
    before, behind = STRINGS.sub(blanked, text[line.start : span.start]), text[span.end : line.end]
    depth, first = 0, -1
    for at, sign in enumerate(before):
        depth += (sign in "([{") - (sign in ")]}")
        first = at if sign in "([{" and depth == 1 else first
    closing = CLOSING.fullmatch(behind)
    if depth < 1 or closing is None or len(closing[1]) < depth or "\n" in text[span.start : span.end]:
        return None
    return Span(line.start + first + 1, span.end + depth - 1)


def blanked(found: re.Match[str]) -> str:
    return " " * len(found[0])
