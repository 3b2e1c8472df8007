"""Defaults of a package's own functions that every call replaces, so that what is wrong with them does no harm."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, defaults_of, functions_of, last_name, nodes_of, nodes_of_kind
from ...source import Span


def is_always_given(files: Iterable[PythonFile], file: PythonFile, place: Span) -> bool:
    """Return whether a place is in the default of a parameter that all calls give; one that nothing calls has none."""
    files = tuple(files)
    for function in functions_of(file.tree):
        for parameter, default in defaults_of(function.args):
            if file.span(default).holds(place):
                return is_given(files, file, function, parameter.arg)
    return False


def is_given(files: tuple[PythonFile, ...], file: PythonFile, function: FunctionNode, name: str) -> bool:
    owners = (each for each in nodes_of_kind(file.tree, ast.ClassDef) if function in each.body)
    owner = next(owners, None)
    called = owner.name if owner is not None and function.name == "__init__" else function.name
    places = [each.arg for each in (*function.args.posonlyargs, *function.args.args)][owner is not None :]
    calls = [each for one in files for each in nodes_of_kind(one.tree, ast.Call) if last_name(each.func) == called]
    heads = {id(each.func) for each in calls}
    others = (each for one in files for each in nodes_of(one.tree) if isinstance(each, (ast.Name, ast.Attribute)))
    if not calls or any(last_name(each) == called and id(each) not in heads for each in others):
        return False  # it may be handed on, or have heirs
    return all(gives(call, name, places) for call in calls)


def gives(call: ast.Call, name: str, places: list[str]) -> bool:
    """Return whether a call surely gives a parameter."""
    before = next((at for at, each in enumerate(call.args) if isinstance(each, ast.Starred)), len(call.args))
    return any(each.arg == name for each in call.keywords) or name in places[:before]
