"""The nodes of a syntax tree, found once however many ask."""

from __future__ import annotations

import ast


def children_of(node: ast.AST) -> list[ast.AST]:
    """Return what `ast.iter_child_nodes` yields."""
    found: list[ast.AST] = []
    for name in node._fields:
        value = getattr(node, name, None)
        if value.__class__ is list:
            found += [each for each in value if isinstance(each, ast.AST)]
        elif isinstance(value, ast.AST):
            found.append(value)
    return found


def nodes_of(root: ast.AST) -> list[ast.AST]:
    """Return what `ast.walk` yields, in its order; kept with the root, as no tree is changed here."""
    known = root.__dict__
    below: list[ast.AST] | None = known.get("nodes_below")
    if below is None:
        below = children_of(root)
        for node in below:  # it grows meanwhile
            for name in node._fields:
                value = getattr(node, name, None)
                if value.__class__ is list:
                    below += [each for each in value if isinstance(each, ast.AST)]
                elif isinstance(value, ast.AST):
                    below.append(value)
        known["nodes_below"] = below  # without the root, or it could not be freed without the collector
    return [root, *below]
