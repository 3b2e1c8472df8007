"""What short functions of a launch file make of the text of an argument: `to_bool(sim.perform(context))`."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from .plain_values import Known, NotKnownError, plain_value

STATES = {
    **dict.fromkeys(("true", "1", "yes", "on", "y", "t"), True),
    **dict.fromkeys(("false", "0", "no", "off", "n", "f"), False),
}
READERS = frozenset({"literal_eval", "eval", "loads", "safe_load", "strtobool"})
"""Functions of libraries that make a truth of a text."""
Helpers = Mapping[str, ast.FunctionDef]


def helpers_in(file: PythonFile) -> dict[str, ast.FunctionDef]:
    """Return the functions of a file that take one value, by their names, as far as these are of one function each."""
    found: dict[str, list[ast.FunctionDef]] = {}
    for each in nodes_of_kind(file.tree, ast.FunctionDef):
        found.setdefault(each.name, []).append(each)
    return {name: each[0] for name, each in found.items() if len(each) == 1 and len(each[0].args.args) == 1}


def value_of_call(call: ast.Call, helpers: Helpers, known: Known) -> object:
    """Return what a helper of the file, or a reader of a library, gives for one value; raises NotKnownError."""
    name = last_name(call.func) or ""
    if len(call.args) != 1 or call.keywords:
        raise NotKnownError
    given = plain_value(call.args[0], known)
    if isinstance(call.func, ast.Name) and name in helpers:
        return returned(helpers[name], given)
    if name in READERS and isinstance(given, str) and given.strip().lower() in STATES:
        return STATES[given.strip().lower()]
    raise NotKnownError


def returned(function: ast.FunctionDef, given: object) -> object:
    """Return what a function of nothing but conditions and returns gives; raises NotKnownError."""
    parameter = function.args.args[0].arg

    def known(node: ast.expr) -> object:
        match node:
            case ast.Name(id=name) if name == parameter:
                return given
            case ast.Call(func=ast.Name(id="isinstance"), args=[ast.Name(id=name), ast.Name(id=kind)]):
                if name == parameter:
                    return type(given).__name__ == kind
        raise NotKnownError

    for each in function.body:
        match each:
            case ast.Expr(value=ast.Constant()):
                continue
            case ast.Return(value=ast.expr() as value):
                return plain_value(value, known)
            case ast.If(test=test, body=[ast.Return(value=ast.expr() as value)], orelse=[]):
                if plain_value(test, known):
                    return plain_value(value, known)
            case _:
                break
    raise NotKnownError
