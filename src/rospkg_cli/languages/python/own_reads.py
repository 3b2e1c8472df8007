"""What the methods of a class read of their own object."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .attributes import is_of_self
from .guarded_nodes import guarded_nodes
from .nodes import FunctionNode, children_of, nodes_of


def own_reads(owner: ast.ClassDef) -> Iterator[ast.Attribute]:
    """Yield the attributes that methods read of their object, but for those that code is ready to miss."""
    ready = set(guarded_nodes([owner], {"AttributeError"}))
    for each in own_nodes(owner):
        node = each.target if isinstance(each, ast.AugAssign) else each
        is_read = node is not each or (isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load))
        if is_of_self(node) and is_read and id(node) not in ready and not node.attr.startswith("__"):
            yield node


def own_nodes(owner: ast.ClassDef) -> Iterator[ast.AST]:
    """Yield the nodes of the methods of a class in which `self` is its own object."""
    for method in owner.body:
        if not isinstance(method, FunctionNode) or not method.args.args or is_static(method):
            continue
        if method.args.args[0].arg == "self" and not rebinds(method, "self"):
            yield from below(method)


def own_calls(owner: ast.ClassDef) -> Iterator[tuple[ast.Call, ast.Attribute]]:
    """Yield the calls that a class makes of its own object, with their functions, in the order of the text."""
    for each in own_nodes(owner):
        if isinstance(each, ast.Call) and is_of_self(each.func):
            yield each, each.func


def below(method: FunctionNode) -> Iterator[ast.AST]:
    """Yield the nodes of a method, without those of classes in it and of functions that have a `self` of their own."""
    waiting: list[ast.AST] = [*method.body[::-1]]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.ClassDef) or (isinstance(node, FunctionNode) and has_own_self(node)):
            continue
        yield node
        waiting += children_of(node)[::-1]


def has_own_self(function: FunctionNode) -> bool:
    return any(each.arg == "self" for each in function.args.args)


def rebinds(method: FunctionNode, name: str) -> bool:
    return any(n.id == name and isinstance(n.ctx, ast.Store) for n in nodes_of(method) if isinstance(n, ast.Name))


def is_static(method: FunctionNode) -> bool:
    return any(ast.unparse(each) in ("staticmethod", "classmethod") for each in method.decorator_list)
