"""What the methods of a class read of their own object."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .guarded_nodes import guarded_nodes
from .nodes import FunctionNode, children_of, nodes_of


def own_reads(owner: ast.ClassDef) -> Iterator[ast.Attribute]:
    """Yield the attributes that methods read of their object, but for those that code is ready to miss."""
    ready = set(guarded_nodes([owner], {"AttributeError"}))
    for method in owner.body:
        if not isinstance(method, FunctionNode) or not method.args.args or is_static(method):
            continue
        own = method.args.args[0].arg
        if own != "self" or rebinds(method, own):
            continue
        for each in below(method):
            node = each.target if isinstance(each, ast.AugAssign) else each
            is_read = node is not each or (isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load))
            match node:
                case ast.Attribute(value=ast.Name(id=name)) if name == own and is_read:
                    if id(node) not in ready and not node.attr.startswith("__"):
                        yield node


def below(method: FunctionNode) -> Iterator[ast.AST]:
    """Yield the nodes of a method, without those of classes in it and of functions that have a `self` of their own."""
    waiting: list[ast.AST] = [*method.body]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.ClassDef) or (isinstance(node, FunctionNode) and has_own_self(node)):
            continue
        yield node
        waiting += children_of(node)


def has_own_self(function: FunctionNode) -> bool:
    return any(each.arg == "self" for each in function.args.args)


def rebinds(method: FunctionNode, name: str) -> bool:
    return any(n.id == name and isinstance(n.ctx, ast.Store) for n in nodes_of(method) if isinstance(n, ast.Name))


def is_static(method: FunctionNode) -> bool:
    return any(ast.unparse(each) in ("staticmethod", "classmethod") for each in method.decorator_list)
