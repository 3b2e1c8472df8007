"""The nodes of a tree come as `ast` yields them, and are looked for once."""

from __future__ import annotations

import ast
from pathlib import Path

from rospkg_cli.languages.python.nodes import children_of, nodes_of


def test_nodes_come_as_ast_yields_them() -> None:
    for path in sorted((Path(__file__).parents[1] / "src" / "rospkg_cli" / "languages").rglob("*.py"))[:20]:
        tree = ast.parse(path.read_text())
        for function in [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]:
            assert nodes_of(function) == list(ast.walk(function))
        assert nodes_of(tree) == list(ast.walk(tree))
        assert all(children_of(node) == list(ast.iter_child_nodes(node)) for node in nodes_of(tree))


def test_nodes_are_looked_for_once_and_freed() -> None:
    tree = ast.parse("x = f(1)")
    found = nodes_of(tree)
    assert all(a is b for a, b in zip(found, nodes_of(tree), strict=True))
    assert tree not in tree.__dict__["nodes_below"]
