"""The nodes of a tree come as `ast` yields them, and are looked for once."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from pathlib import Path

from rospkg_cli.languages.python.nodes import children_of, nodes_of, nodes_of_kind


def test_nodes_come_as_ast_yields_them() -> None:
    for path in sorted((Path(__file__).parents[1] / "src" / "rospkg_cli" / "languages").rglob("*.py"))[:20]:
        tree = ast.parse(path.read_text())
        for function in [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]:
            assert nodes_of(function) == without_contexts(ast.walk(function))
        assert nodes_of(tree) == without_contexts(ast.walk(tree))
        for node in nodes_of(tree):
            assert children_of(node) == without_contexts(ast.iter_child_nodes(node))


def without_contexts(nodes: Iterable[ast.AST]) -> list[ast.AST]:
    return [node for node in nodes if not isinstance(node, ast.expr_context)]


def test_nodes_of_one_kind_come_in_the_same_order() -> None:
    tree = ast.parse("class A:\n  def f(self): return f(g(1))\ndef g(a): return h(a)\n")
    nodes_of(tree.body[0])  # what is kept with a node is none of its fields
    for kind in (ast.Call, ast.Name, ast.FunctionDef, ast.Yield):
        assert nodes_of_kind(tree, kind) == [node for node in ast.walk(tree) if isinstance(node, kind)]


def test_nodes_are_looked_for_once_and_freed() -> None:
    tree = ast.parse("x = f(1)")
    found = nodes_of(tree)
    assert all(a is b for a, b in zip(found, nodes_of(tree), strict=True))
    assert tree not in tree.__dict__["nodes_below"]
