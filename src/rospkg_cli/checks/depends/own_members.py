"""Names that the class around a place has, and that its methods can use only by `self`."""

from __future__ import annotations

import ast

from ...languages.python.attributes import is_of_self
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of_kind
from ...source import Span


def is_own_member(file: PythonFile, name: str, span: Span) -> bool:
    """Return whether a place lies in a method of a class that binds a name, in its body or as `self.name`."""
    around = [each for each in nodes_of_kind(file.tree, ast.ClassDef) if file.span(each).holds(span)]
    in_method = any(file.span(method).holds(span) for each in around for method in methods(each))
    return in_method and any(name in members(each) for each in around)


def members(owner: ast.ClassDef) -> set[str]:
    found = {each.name for each in owner.body if isinstance(each, FunctionNode | ast.ClassDef)}
    for each in owner.body:
        targets = (
            each.targets if isinstance(each, ast.Assign) else [each.target] if isinstance(each, ast.AnnAssign) else []
        )
        found |= {target.id for target in targets if isinstance(target, ast.Name)}
    attributes = nodes_of_kind(owner, ast.Attribute)
    return found | {each.attr for each in attributes if isinstance(each.ctx, ast.Store) and is_of_self(each)}


def methods(owner: ast.ClassDef) -> list[FunctionNode]:
    return [each for each in owner.body if isinstance(each, FunctionNode) and is_bound(each)]


def is_bound(method: FunctionNode) -> bool:
    return bool(method.args.args) and method.args.args[0].arg == "self"
