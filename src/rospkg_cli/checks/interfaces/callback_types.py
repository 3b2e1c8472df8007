"""The messages that callbacks receive, by the subscription, service or action they are registered for."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator

from ...languages.python.attributes import is_of_self
from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_below, nodes_of_kind
from .message_classes import MessageClasses

BY_NAME = 99
"""The position of what is given by its name alone."""
REGISTER: dict[str, tuple[int, int, str, tuple[str, ...]]] = {
    "create_subscription": (0, 2, "callback", ("",)),
    "create_service": (0, 2, "callback", ("_Request", "_Response")),
    "ActionServer": (1, BY_NAME, "goal_callback", ("_Goal",)),
}
"""Which arguments of a method of a node, or of a class, are the interface and the callback, and which parts of the
interface that is called with."""

KINDS = {"create_subscription": "msg", "create_service": "srv", "ActionServer": "action"}

Callbacks = dict[tuple[str, str], tuple[str, ...]]
"""The messages of the parameters, by class (or "") and function."""


def callback_types(file: PythonFile, classes: MessageClasses) -> Callbacks:
    """Return what functions are called with that are registered, once or for one type, and named nowhere else."""
    if not any(name in file.source.text for name in REGISTER):
        return {}
    found: dict[tuple[str, str], list[tuple[str, ...]]] = {}
    for owner, scope in scopes(file.tree):
        for node in nodes_below(scope):
            if isinstance(node, ast.Call) and (registered := registration(node, classes)) is not None:
                function, types = registered
                if isinstance(function, ast.Attribute):
                    found.setdefault((owner, function.attr), []).append(types)
                elif not owner:
                    found.setdefault(("", function.id), []).append(types)
    named = Counter(mentions(file.tree))
    return {key: types[0] for key, types in found.items() if len(set(types)) == 1 and named[key[1]] == len(types)}


def scopes(tree: ast.Module) -> Iterator[tuple[str, ast.AST]]:
    """Yield the file itself, as "", and each of its classes."""
    yield "", tree
    yield from ((node.name, node) for node in nodes_of_kind(tree, ast.ClassDef))


def mentions(tree: ast.Module) -> Iterator[str]:
    yield from (node.attr for node in nodes_of_kind(tree, ast.Attribute))
    yield from (node.id for node in nodes_of_kind(tree, ast.Name))


def registration(call: ast.Call, classes: MessageClasses) -> tuple[ast.Attribute | ast.Name, tuple[str, ...]] | None:
    """Return the function that a call registers, `self.function` or `function`, and the messages it will be given."""
    name_called = last_name(call.func)
    if name_called not in REGISTER or (isinstance(call.func, ast.Name) and name_called != "ActionServer"):
        return None
    of_kind, position, keyword, suffixes = REGISTER[name_called]
    given = {each.arg: each.value for each in call.keywords}
    if None in given or "raw" in given or any(isinstance(each, ast.Starred) for each in call.args):
        return None
    if len(call.args) <= of_kind:
        return None
    function = call.args[position] if position < len(call.args) else given.get(keyword)
    name = classes.named(call.args[of_kind])
    if name.split("/")[1:2] != [KINDS[name_called]]:
        return None
    if function is not None and is_of_self(function):
        return function, tuple(f"{name}{suffix}" for suffix in suffixes)
    return (function, tuple(f"{name}{suffix}" for suffix in suffixes)) if isinstance(function, ast.Name) else None
