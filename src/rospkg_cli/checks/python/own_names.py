"""The names by which a function, a class or a module may lead to definitions."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, children_of
from ..paths.logged_texts import logged_texts

LINTERS = "ament_"
"""How the modules begin whose `main` the tests call that every package has."""
SELF = "self."
"""Begins a name that is looked for in the object whose method it stands in."""


def own_names(file: PythonFile, scope: ast.AST, off: Collection[int] = ()) -> Iterator[str]:
    """Yield the names and strings that a scope mentions, without the bodies of definitions in it, without logs, and
    without what is turned `off`.

    To import a name leads to nothing before that is used, under its own or another name; a package offers it to others.
    """
    logged = logged_texts(file)
    is_package = file.path.endswith("__init__.py")
    of_linters = {name for each in file.imports if each.module.startswith(LINTERS) for name in each.names}
    waiting = children_of(scope)
    while waiting:
        node = waiting.pop()
        if id(node) in off:
            continue
        match node:
            case ast.Attribute(value=ast.Name(id="self"), attr=name):
                yield f"{SELF}{name}"
            case ast.Name(id=name) if name in of_linters:
                pass
            case ast.Name(id=name) | ast.Attribute(attr=name):
                yield name
            case ast.Constant(value=str(name)) if id(node) not in logged:
                yield name
            case ast.alias(name=name, asname=asname) if asname or is_package:
                yield name
        if isinstance(node, FunctionNode):
            waiting += [node.args, *node.decorator_list]
        elif isinstance(node, ast.ClassDef):
            waiting += [*node.bases, *node.decorator_list]
        else:
            waiting += children_of(node)
