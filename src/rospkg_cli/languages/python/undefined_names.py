"""Names that a Python file uses and that nothing in it defines or imports."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile
from .guarded_nodes import guarded_nodes
from .name_scopes import names_unseen
from .nodes import nodes_of, nodes_of_kind
from .unread_types import all_annotations

BROAD = frozenset({"Exception", "BaseException"})


@dataclass(frozen=True, slots=True)
class UndefinedName:
    """A use of a name that no scope binds."""

    name: str
    span: Span
    known: frozenset[str]
    """The names that are bound there, without builtins."""
    is_annotation: bool = False
    """Whether it is in an annotation, which Python 3.14 and later do not read at the definition."""
    is_caught: bool = False
    """Whether it is in a `try` that catches every exception."""


def undefined_names(file: PythonFile, *, everywhere: bool = False, with_types: bool = False) -> Iterator[UndefinedName]:
    """Yield uses of names that no scope around them binds; none where a file may have names that are not in its text.

    Args:
        everywhere: also in annotations, where any exception is caught, and in files with star imports, of which the
            caller knows what they import.
        with_types: also in annotations.
    """
    if file.has_dynamic_names or (not everywhere and any("*" in each.names for each in file.imports)):
        return
    if any(node.id in ("exec", "eval", "locals") for node in nodes_of_kind(file.tree, ast.Name)):
        return
    found = [*names_unseen(file.tree.body, frozenset(file.definitions))]
    annotations = frozenset(annotated(file)) if found else frozenset()
    caught = frozenset(guarded_nodes(file.tree.body, BROAD)) if found else frozenset()
    for name, known in found:
        each = UndefinedName(name.id, file.span(name), known, id(name) in annotations, id(name) in caught)
        is_read = not each.is_annotation or "annotations" not in file.definitions
        is_asked = everywhere or (not each.is_caught and (with_types or not each.is_annotation))
        if is_asked and is_read:
            yield each


def annotated(file: PythonFile) -> Iterator[int]:
    """Yield the identity of each node in an annotation."""
    yield from (id(node) for each in all_annotations(file) for node in nodes_of(each))
