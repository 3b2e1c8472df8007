"""What the parser takes and Python's compiler refuses: a keyword given twice, `return` outside of a function."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterable, Sequence
from itertools import pairwise

from ...source import Source
from .nodes import nodes_below

SIMPLE = frozenset({
    ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr, ast.Import, ast.ImportFrom, ast.Raise, ast.Assert, ast.Delete,
    ast.Pass, ast.Global, ast.Nonlocal,
})  # fmt: skip
"""The statements without blocks that may stand anywhere."""
ENDS = frozenset({ast.Return, ast.Break, ast.Continue})
SCOPES = frozenset({ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef})
LOOPS = frozenset({ast.For, ast.AsyncFor, ast.While})
SELDOM = frozenset({ast.Global, ast.Nonlocal, ast.Await, ast.AsyncFor, ast.AsyncWith})
"""What is often written where the compiler refuses it: a file that has one is compiled to see."""
ASKED = SELDOM | {ast.ClassDef, ast.arguments, ast.Try, ast.ImportFrom}
OF_OLDER = "asynchronous comprehension outside"
"""What an older Python refuses, and a newer one takes."""


def compile_error(source: Source, tree: ast.Module) -> SyntaxError | None:
    """Return what stops Python behind the parser, by compiling the few files that may have such a thing.

    Nothing is run: the code that comes of it is dropped.
    """
    if not (has_seldom_nodes(tree) or has_loose_statements(tree.body) or has_late_future(tree)):
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(source.text, source.path, "exec", dont_inherit=True)
    except SyntaxError as error:
        return None if OF_OLDER in str(error.msg) else error
    except (RecursionError, MemoryError, ValueError):
        return None
    return None


def has_seldom_nodes(tree: ast.Module) -> bool:
    """Return whether a tree has nodes that the compiler may refuse by themselves or where they stand."""
    for node in nodes_below(tree):
        if isinstance(node, ast.Call):  # the most frequent ones
            if len(node.keywords) > 1 and has_doubles([each.arg for each in node.keywords]):
                return True
        elif node.__class__ in ASKED and may_be_refused(node):
            return True
    return False


def may_be_refused(node: ast.AST) -> bool:
    match node:
        case ast.ClassDef(keywords=keywords):
            return has_doubles([each.arg for each in keywords])
        case ast.arguments():
            return has_doubles([each.arg for each in arguments_of(node)])
        case ast.Try(handlers=handlers):
            return any(each.type is None for each in handlers[:-1])
        case ast.ImportFrom(module=module, names=names):
            return node.col_offset > 0 and (module == "__future__" or names[0].name == "*")
    return True


def has_late_future(tree: ast.Module) -> bool:
    """Return whether `from __future__ import …` stands behind other statements."""
    has_text = bool(tree.body) and isinstance(tree.body[0], ast.Expr) and isinstance(tree.body[0].value, ast.Constant)
    is_future = [isinstance(each, ast.ImportFrom) and each.module == "__future__" for each in tree.body[has_text:]]
    return any(later and not first for first, later in pairwise(is_future))


def arguments_of(node: ast.arguments) -> list[ast.arg]:
    others = [each for each in (node.vararg, node.kwarg) if each is not None]
    return [*node.posonlyargs, *node.args, *node.kwonlyargs, *others]


def has_doubles(names: Sequence[str | None]) -> bool:
    """Return whether a name stands twice; `**more` has none."""
    known = {*names} - {None}
    return len(names) > len(known) and len(names) - names.count(None) > len(known)


def has_loose_statements(body: Iterable[ast.stmt], in_function: bool = False, in_loop: bool = False) -> bool:
    """Return whether `return` stands outside of functions, or `break` and `continue` outside of loops."""
    for node in body:
        kind = node.__class__
        if kind in SIMPLE:
            continue
        if kind in ENDS:
            if not (in_function if kind is ast.Return else in_loop):
                return True
        elif kind in SCOPES:
            if has_loose_statements(blocks_of(node)[0], kind is not ast.ClassDef):
                return True
        else:
            first, *others = blocks_of(node)
            if has_loose_statements(first, in_function, in_loop or kind in LOOPS):
                return True
            if any(has_loose_statements(each, in_function, in_loop) for each in others):
                return True
    return False


def blocks_of(node: ast.stmt) -> list[list[ast.stmt]]:
    """Return the blocks of a statement, its first one first."""
    parts: dict[str, list[ast.stmt]] = node.__dict__
    handled = [vars(each)["body"] for each in parts.get("handlers", [])]
    return [parts.get("body", []), *handled, parts.get("orelse", []), parts.get("finalbody", [])]
