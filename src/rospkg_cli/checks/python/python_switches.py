"""Conditions of Python code on a parameter, an option or a variable whose default keeps them from holding."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ...package.params.python_parameters import declared_in
from ...source import Span
from .switch import Switch

READS = frozenset({"get_parameter", "declare_parameter"})
VALUES = frozenset({"value", "bool_value", "integer_value", "get_parameter_value"})
STATES = {"False": False, "0": False, "True": True, "1": True}


def python_switches(file: PythonFile, span: Span, files: Iterable[PythonFile]) -> Iterator[Switch]:
    """Yield the conditions around a place that do not hold by default."""
    files = tuple(files)
    for test, is_on in conditions(file, span):
        yield from outer_switches(test, file, is_on)
        names = parameters_in(test, file, files)
        defaults = {state for name in names for state in defaults_of(name, files)}
        if names and defaults == {not is_on}:
            yield Switch(ast.unparse(test), tuple(sorted(names)), is_on)


def outer_switches(test: ast.expr, file: PythonFile, is_on: bool) -> Iterator[Switch]:
    """Yield a condition that does not hold as long as no command gives an option, or nothing sets a variable."""
    match test:
        case ast.Attribute(attr=name) if is_on and (option := flag_of(name, file)):
            yield Switch(ast.unparse(test), (option,), is_on, "option")
        case ast.Compare(left=asked, ops=[ast.Eq()], comparators=[ast.Constant(value=value)]) if value and is_on:
            if name := unset_variable(asked):
                yield Switch(ast.unparse(test), (name,), is_on, "variable")
        case ast.Call() if is_on and (name := unset_variable(test)):
            yield Switch(ast.unparse(test), (name,), is_on, "variable")


def flag_of(name: str, file: PythonFile) -> str:
    """Return the option of a command that makes a name true, and is off without it: `--debug`; "" for none."""
    for call in nodes_of_kind(file.tree, ast.Call):
        words = [each.value for each in call.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        given = {each.arg: each.value for each in call.keywords}
        is_flag = last_name(call.func) == "add_argument" and text_of(given.get("action")) == "store_true"
        long = next((each for each in words if each.startswith("--")), "")
        if is_flag and "default" not in given and (text_of(given.get("dest")) or long[2:].replace("-", "_")) == name:
            return long if "set_defaults" not in file.source.text else ""
    return ""


def text_of(node: ast.expr | None) -> str:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def unset_variable(node: ast.expr) -> str:
    """Return the variable of the environment that an expression asks for, without a default that is true."""
    match node:
        case ast.Call(func=ast.Attribute(value=of, attr=method), args=[ast.Constant(value=str(name)), *rest]) if (
            method == "get" and last_name(of) == "environ"
        ) or method == "getenv":
            is_off = not rest or (isinstance(rest[0], ast.Constant) and rest[0].value in (None, "", "0", "false", 0))
            return name if is_off else ""
    return ""


def conditions(file: PythonFile, span: Span) -> Iterator[tuple[ast.expr, bool]]:
    """Yield what has to hold for a place to run, each with the truth that it has to have."""
    for node in nodes_of_kind(file.tree, ast.If):
        for branch, is_on in ((node.body, True), (node.orelse, False)):
            if any(file.span(each).holds(span) for each in branch):
                yield from parts(node.test, is_on)


def parts(test: ast.expr, is_on: bool) -> Iterator[tuple[ast.expr, bool]]:
    """Yield the parts of a condition that all have to be so."""
    waiting = [(test, is_on)]
    while waiting:
        node, wanted = waiting.pop()
        match node:
            case ast.UnaryOp(op=ast.Not(), operand=inner):
                waiting.append((inner, not wanted))
            case ast.BoolOp(op=op, values=values):
                waiting += [(each, wanted) for each in values] if isinstance(op, ast.And) is wanted else []
            case _:
                yield node, wanted


def parameters_in(test: ast.expr, file: PythonFile, files: tuple[PythonFile, ...]) -> frozenset[str]:
    """Return the parameters that an expression has its value of; none where it may have another."""
    if name := parameter_of(test):
        return frozenset({name})
    if not isinstance(test, ast.Name | ast.Attribute):
        return frozenset()
    text, last = ast.unparse(test), test.attr if isinstance(test, ast.Attribute) else ""
    given = [each.value for each in nodes_of_kind(file.tree, ast.Assign) if [*map(ast.unparse, each.targets)] == [text]]
    names = [parameter_of(each) for each in given]
    if not all(names) or not names:
        return frozenset()
    stores = [each for one in (files if last else (file,)) for each in nodes_of(one.tree) if is_store(each, text, last)]
    return frozenset(names) if len(stores) == len(given) else frozenset()


def is_store(node: ast.AST, text: str, last: str) -> bool:
    """Return whether a node binds a name, or a member of a name in any object; so does a parameter of a function."""
    if isinstance(node, ast.arg):
        return node.arg == text
    if not isinstance(node, ast.Name | ast.Attribute) or isinstance(node.ctx, ast.Load):
        return False
    return node.attr == last if isinstance(node, ast.Attribute) else node.id == text


def parameter_of(node: ast.expr) -> str:
    """Return the parameter that an expression is the value of; "" for others."""
    while True:
        match node:
            case ast.Call(func=ast.Name(id="bool" | "int"), args=[inner]):
                node = inner
            case ast.Attribute(value=inner, attr=name) if name in VALUES:
                node = inner
            case ast.Call(func=ast.Attribute(value=inner, attr="get_parameter_value")):
                node = inner
            case ast.Call(func=ast.Attribute(attr=method), args=[ast.Constant(value=str(name)), *_]):
                return name if method in READS else ""
            case _:
                return ""


def defaults_of(name: str, files: Iterable[PythonFile]) -> Iterator[bool | None]:
    """Yield the truth of each default that code declares a parameter with; None where it is not known."""
    for file in files:
        yield from (STATES.get(each.default) for each in declared_in(file) if each.fits(name))
