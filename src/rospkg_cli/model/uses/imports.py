"""The imports of a Python file: each with its span, and whether the file does without it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

from ...source import Span
from ..python import PythonFile

FROM = re.compile(r"from\s+([\w.]+)")
CAUGHT = frozenset({"ImportError", "ModuleNotFoundError", "Exception", "BaseException"})
TYPING = frozenset({"TYPE_CHECKING"})
MACHINE = frozenset({"sys", "os", "platform", "find_spec", "version_info", "environ", "PY2", "PY3", "version"})
"""A condition that asks for one of these asks where it runs: the other machine needs nothing."""


@dataclass(frozen=True, slots=True)
class Import:
    """One module that a file imports by its full name; relative imports are its own affair."""

    module: str
    names: tuple[str, ...]
    """What is taken out of it: of `from m import a, b` the names, else nothing."""
    span: Span
    """Of the module's name."""
    optional: bool = False
    """Whether the file does without it: a caught ImportError, TYPE_CHECKING, a condition on the machine."""


def imports_of(file: PythonFile) -> Iterator[Import]:
    """Yield every absolute import, also those inside of functions, in the order of the text."""
    return visit(file, file.tree.body, False)


def visit(file: PythonFile, body: list[ast.stmt], optional: bool) -> Iterator[Import]:
    for node in body:
        match node:
            case ast.Import():
                for alias in node.names:
                    span = file.span(alias)
                    yield Import(alias.name, (), Span(span.start, span.start + len(alias.name)), optional)
            case ast.ImportFrom(module=str(module), level=0):
                names = tuple(alias.name for alias in node.names)
                yield Import(module, names, module_span(file, node), optional)
            case ast.Try():
                caught = optional or any(catches(handler) for handler in node.handlers)
                yield from visit(file, node.body, caught)
                for handler in node.handlers:
                    yield from visit(file, handler.body, caught)
                yield from visit(file, node.orelse, caught)
                yield from visit(file, node.finalbody, optional)
            case ast.If():
                words = names_in(node.test)
                asks = bool(words & MACHINE)
                yield from visit(file, node.body, optional or asks or bool(words & TYPING))
                yield from visit(file, node.orelse, optional or asks)
            case ast.With() | ast.AsyncWith():
                suppressed = any("suppress" in names_in(i.context_expr) for i in node.items)
                yield from visit(file, node.body, optional or suppressed)
            case ast.Match():
                for case in node.cases:
                    yield from visit(file, case.body, optional)
            case _:
                for part in ("body", "orelse"):
                    yield from visit(file, getattr(node, part, []), optional)


def catches(handler: ast.ExceptHandler) -> bool:
    """Return whether a handler takes what a failing import raises."""
    return handler.type is None or bool(names_in(handler.type) & CAUGHT)


def names_in(node: ast.expr) -> set[str]:
    """Return the names and attributes that stand anywhere in an expression."""
    found = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
    return found | {each.attr for each in ast.walk(node) if isinstance(each, ast.Attribute)}


def module_span(file: PythonFile, node: ast.ImportFrom) -> Span:
    whole = file.span(node)
    found = FROM.match(file.source.text, whole.start)
    return Span(*found.span(1)) if found else whole
