"""Functions of a Python file that nothing calls or passes on, seen from its module level and from entry points."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from .file import PythonFile
from .nodes import children_of, nodes_of

Definition = ast.FunctionDef | ast.AsyncFunctionDef


def unreached_functions(file: PythonFile, entries: Collection[str]) -> list[Definition]:
    """Return the functions to which neither the module level nor an entry point leads, the outermost ones first.

    A mention of its name leads to a function: it is called there, or passed to what calls it.
    A decorated function may be registered by its decorator, and a method called by whoever has the object.
    """
    functions = [node for node in nodes_of(file.tree) if isinstance(node, Definition)]
    methods = {id(each) for node in nodes_of(file.tree) if isinstance(node, ast.ClassDef) for each in node.body}
    waiting: list[ast.AST] = [file.tree]
    waiting += [each for each in functions if each.name in entries or each.decorator_list or id(each) in methods]
    reached = {id(each) for each in waiting}
    while waiting:
        names = set(mentioned(waiting.pop()))
        found = [each for each in functions if each.name in names and id(each) not in reached]
        reached |= {id(each) for each in found}
        waiting += found
    return [each for each in functions if id(each) not in reached]


def mentioned(scope: ast.AST) -> Iterator[str]:
    """Yield the names that a scope reads, without the bodies of the functions that it defines."""
    waiting = children_of(scope)
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Name):
            yield node.id
        elif isinstance(node, ast.Attribute):
            yield node.attr
        waiting += [node.args, *node.decorator_list] if isinstance(node, Definition) else children_of(node)
