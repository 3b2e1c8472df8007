"""Parameters declared in Python: `declare_parameter(name, default)` and `declare_parameters(namespace, [...])`."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...source import Span
from .declared_parameter import DeclaredParameter

RCL_TYPES = {
    "BOOL": "bool", "INTEGER": "int", "DOUBLE": "double", "STRING": "string", "BOOL_ARRAY": "bool[]",
    "INTEGER_ARRAY": "int[]", "DOUBLE_ARRAY": "double[]", "STRING_ARRAY": "string[]",
}  # fmt: skip
READS = frozenset({"get_parameter", "get_parameter_or"})
PLAIN_TYPES = {bool: "bool", int: "int", float: "double", str: "string"}

TypeOf = Callable[[str], str]
"""The type of a constant by its name, "" where it is unknown."""


def unknown(_: str) -> str:
    return ""


def constants_in(file: PythonFile) -> Iterator[tuple[str, str]]:
    """Yield the names that a module or a class of it binds, with the type of the value."""
    bodies = [file.tree.body, *(each.body for each in nodes_of_kind(file.tree, ast.ClassDef))]
    for statement in (each for body in bodies for each in body):
        match statement:
            case (
                ast.Assign(targets=[ast.Name(id=name)], value=value)
                | ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value)
            ):
                yield name, type_of(value)


def declared_in(file: PythonFile, constant: TypeOf = unknown) -> Iterator[DeclaredParameter]:
    """Yield what a file declares under literal names."""
    for call in nodes_of_kind(file.tree, ast.Call):
        if isinstance(call.func, ast.Attribute):
            yield from declared_by(file, call, call.func.attr, constant)


def declared_by(
    file: PythonFile, call: ast.Call, method: str, constant: TypeOf = unknown
) -> Iterator[DeclaredParameter]:
    """Yield what one call declares under literal names; what ignores overrides has any type."""
    if method == "declare_parameter":
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        name = call.args[0] if call.args else given.get("name")
        value = call.args[1] if len(call.args) > 1 else given.get("value")
        ignores = call.args[3] if len(call.args) > 3 else given.get("ignore_override")
        is_taken = ignores is None or (isinstance(ignores, ast.Constant) and not ignores.value)
        yield from declaration(file, "", name, value if is_taken else None, constant)
    elif method == "declare_parameters":
        yield from several(file, call, constant)


def several(file: PythonFile, call: ast.Call, constant: TypeOf) -> Iterator[DeclaredParameter]:
    given = {keyword.arg: keyword.value for keyword in call.keywords}
    space = call.args[0] if call.args else given.get("namespace")
    listed = listed_in(call)
    if isinstance(space, ast.Constant) and isinstance(space.value, str) and isinstance(listed, ast.List | ast.Tuple):
        prefix = f"{space.value}." if space.value else ""
        for each in listed.elts:
            if isinstance(each, ast.Tuple | ast.List) and each.elts:
                value = each.elts[1] if len(each.elts) > 1 else None
                yield from declaration(file, prefix, each.elts[0], value, constant)


def listed_in(call: ast.Call) -> ast.expr | None:
    """Return the list of a `declare_parameters`."""
    named = [keyword.value for keyword in call.keywords if keyword.arg == "parameters"]
    return call.args[1] if len(call.args) > 1 else next(iter(named), None)


def read_in(file: PythonFile) -> Iterator[tuple[DeclaredParameter, Span, bool]]:
    """Yield the parameters that a file gets by a literal name, where it stands, and whether an unknown one raises."""
    for node in nodes_of_kind(file.tree, ast.Call):
        if (
            isinstance(node.func, ast.Attribute)
            and node.func.attr in ("get_parameter", "get_parameter_or")
            and node.args
        ):
            name = node.args[0]
            if isinstance(name, ast.Constant) and isinstance(name.value, str) and name.value:
                read = DeclaredParameter(name.value, False, "", False, file.source.path)
                yield read, file.span(name), node.func.attr == "get_parameter"


def has_computed_names(file: PythonFile) -> bool:
    """Return whether a file declares parameters under names that are only known at run time."""
    for call in nodes_of_kind(file.tree, ast.Call):
        method = call.func.attr if isinstance(call.func, ast.Attribute) else ""
        if method in ("declare_parameter", "declare_parameters"):
            listed = listed_in(call) if method == "declare_parameters" else None
            wanted = len(listed.elts) if isinstance(listed, ast.List | ast.Tuple) else 1
            if len(list(declared_by(file, call, method))) < wanted:
                return True
    return False


def declaration(
    file: PythonFile, prefix: str, name: ast.expr | None, value: ast.expr | None, constant: TypeOf
) -> Iterator[DeclaredParameter]:
    if isinstance(name, ast.Constant) and isinstance(name.value, str) and name.value:
        kind = type_of(value, constant) if value is not None else ""
        default = str(value.value) if isinstance(value, ast.Constant) and value.value is not None else ""
        yield DeclaredParameter(prefix + name.value, False, kind, False, file.source.path, default)


def type_of(value: ast.expr, constant: TypeOf = unknown) -> str:
    """Return the type of parameter that a default value makes; "" where it is unknown."""
    match value:
        case ast.Constant(value=plain):
            return PLAIN_TYPES.get(type(plain), "")
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=inner):
            return type_of(inner, constant)
        case ast.List(elts=[first, *others]) | ast.Tuple(elts=[first, *others]):
            kinds = {type_of(each) for each in (first, *others)}
            kind = kinds.pop()
            return f"{kind}[]" if kind and not kinds and "[" not in kind else ""
        case ast.Attribute(attr=name, value=ast.Attribute(attr="Type") | ast.Name(id="ParameterType")):
            return RCL_TYPES.get(name.removeprefix("PARAMETER_"), "")
        case ast.Name(id=name) if name.isupper():
            return constant(name)
        case ast.Attribute(value=ast.Name(id=owner), attr=name) if owner[0].isupper():
            return constant(name)
        case ast.JoinedStr():
            return "string"
        case ast.Call(func=ast.Name(id="str" | "float" | "int" | "bool" as name)):
            return {"str": "string", "float": "double", "int": "int", "bool": "bool"}[name]
    return ""
