"""Branches of Python code for versions of Python that no supported distribution has."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...lazy_regex import regex
from .file import PythonFile
from .nodes import COMPARISONS, nodes_of, nodes_of_kind

ASKS = regex(
    r"(?i)version_info|hexversion|\bsys\.version|python_version|ROS_(PYTHON_)?VERSION|ROS_DISTRO"
    r"|(?<![a-z0-9])(is_?)?py(thon)?_?[23](?![a-z])"
)
"""What a condition asks of the interpreter, or of the distribution, which has one interpreter: `six.PY2`."""
CALLED = regex(r"(?i)_*(?:is_?)?py(?:thon)?_?([23])_*")
"""Names of what is true in Python 2 or 3 alone."""
MINORS = range(8, 15)
"""The versions 3.x that ROS 2 runs with."""
FIELDS = {"major": 0, "minor": 1}


def guarded_by_version(file: PythonFile) -> Iterator[int]:
    """Yield the identity of each node in a branch that a version of Python decides, but where it surely runs."""
    every: list[ast.If | ast.IfExp] = [*nodes_of_kind(file.tree, ast.If), *nodes_of_kind(file.tree, ast.IfExp)]
    for node in every:
        if ASKS.search(ast.unparse(node.test)) is not None:
            holds = holds_in_python_3(node.test)
            left = [*([] if holds is True else [node.body]), *([] if holds is False else [node.orelse])]
            parts = (part for each in left for part in (each if isinstance(each, list) else [each]))
            yield from (id(inner) for part in parts for inner in nodes_of(part))


def holds_in_python_3(test: ast.expr) -> bool | None:
    """Return what a condition on the version of Python is in each that ROS 2 runs with; None where it differs."""
    match test:
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            inside = holds_in_python_3(operand)
            return None if inside is None else not inside
        case ast.BoolOp(op=joined, values=values):
            decides = isinstance(joined, ast.Or)
            found = [holds_in_python_3(each) for each in values]
            return decides if decides in found else None if None in found else not decides
        case ast.Name(id=name) | ast.Attribute(attr=name):
            called = CALLED.fullmatch(name)
            return called.group(1) == "3" if called is not None else None
        case ast.Compare(left=left, ops=[asked], comparators=[right]):
            return compared(left, asked, right)
    return None


def compared(left: ast.expr, asked: ast.cmpop, right: ast.expr) -> bool | None:
    compare = COMPARISONS.get(asked.__class__)
    try:
        bound = ast.literal_eval(right)
        found = {compare(value_of(left, minor), bound) for minor in MINORS} if compare is not None else set()
    except (ValueError, TypeError, IndexError):
        return None
    return found.pop() if len(found) == 1 else None


def value_of(asked: ast.expr, minor: int) -> object:
    """Return what a Python 3 answers; raises ValueError where it is not asked for its version as numbers."""
    numbers = (3, minor, 0, "final", 0)
    match asked:
        case ast.Name(id="version_info") | ast.Attribute(attr="version_info"):
            return numbers
        case ast.Name(id="hexversion") | ast.Attribute(attr="hexversion"):
            return 0x03000000 + (minor << 16)
        case ast.Attribute(value=inner, attr=name) if name in FIELDS and value_of(inner, minor) == numbers:
            return numbers[FIELDS[name]]
        case ast.Subscript(value=inner, slice=ast.Constant(value=int() as at)) if value_of(inner, minor) == numbers:
            return numbers[at]
        case ast.Subscript(value=inner, slice=ast.Slice(lower=None, upper=ast.Constant(value=int() as end), step=None)):
            return numbers[:end] if value_of(inner, minor) == numbers else None
    raise ValueError
