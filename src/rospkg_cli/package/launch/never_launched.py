"""What a Python launch file makes and launch never visits, as it is no part of the launch description."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from typing import cast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.printed_names import printed_names
from ...languages.python.unread_values import BoundValue, is_stored, local_values, module_values, never_added
from ...languages.python.unread_values import unread_values as unread_in
from ...source import Span
from ..file_role import role_of
from .imported_actions import is_action, is_plain
from .launch_evaluator import ENTRIES
from .uncalled_functions import BY_NAME

TARGETS = frozenset({"target_action", "target_lifecycle_node"})
"""Arguments of event handlers that only say which action they wait for: none is started by them."""
WRITTEN = ast.Tuple | ast.List


def never_launched(file: PythonFile) -> tuple[Span, ...]:
    """Return what nothing reads: the values of names, actions that are statements of their own, and what follows them.

    Whatever reads a name may add it: a function, a list, an attribute. A handler that waits for an action does not, and
    what it holds is never started where nothing else starts the action. What a module binds counts in launch files,
    which nothing imports: they have an entry point of their own. Any other file has only the unread values of locals.
    """
    known = vars(file)
    if "never_launched" not in known:  # asked for every action of the file
        found = unread_values(file, with_printed=True) if is_startable(file) else never_added(file)
        known["never_launched"] = tuple(dict.fromkeys(found))
    return cast("tuple[Span, ...]", known["never_launched"])


def never_shown(file: PythonFile) -> tuple[Span, ...]:
    """Return the same, and what nothing but `print` reads: its text is shown, and nothing done with."""
    known = vars(file)
    if "never_shown" not in known:
        found = unread_values(file, with_printed=False) if next(printed_names(file), None) else never_launched(file)
        known["never_shown"] = tuple(dict.fromkeys(found))
    return cast("tuple[Span, ...]", known["never_shown"])


def unread_values(file: PythonFile, *, with_printed: bool) -> Iterator[Span]:
    """Yield the values; `with_printed` has a name count as read where it is printed."""
    silent = set() if with_printed else {id(name) for name in printed_names(file)}
    more = []
    if is_startable(file):
        targets = list(awaited(file))
        silent |= {id(name) for name, _ in targets}
        more = [*(([], value) for value in bare_actions(file)), *of_module(file), *waiting_for(file, targets)]
    yield from unread_in(file, silent, more)


def is_startable(file: PythonFile) -> bool:
    return any(name in file.functions for name in ENTRIES)


def bare_actions(file: PythonFile) -> Iterator[ast.expr]:
    """Yield the actions that a statement makes and holds nowhere, alone or with commas: `Node(…),`."""
    for statement in nodes_of_kind(file.tree, ast.Expr):
        items = statement.value.elts if isinstance(statement.value, WRITTEN) else [statement.value]
        if items and all(is_action(each, file) for each in items):
            yield statement.value


def of_module(file: PythonFile) -> Iterator[BoundValue]:
    """Yield what the module of a launch file binds; in any other file it may be there for those that import it.

    What calls other code than that of launch may do more than to make a value: it may load a module.
    """
    names = {node.id for node in nodes_of_kind(file.tree, ast.Name)}
    if role_of(file.source.path) == "launch" and names.isdisjoint((*BY_NAME, "__all__")):
        values = module_values(file)
        yield from (each for each in values if is_plain(each[1], file))


def awaited(file: PythonFile) -> Iterator[tuple[ast.Name, ast.Call]]:
    """Yield the names that are the targets of event handlers, with these."""
    for call in nodes_of_kind(file.tree, ast.Call):
        for each in call.keywords:
            if each.arg in TARGETS and isinstance(each.value, ast.Name):
                yield each.value, call


def waiting_for(file: PythonFile, targets: list[tuple[ast.Name, ast.Call]]) -> Iterator[BoundValue]:
    """Yield the handlers that wait for actions of names which hold nothing else: lost where the actions are."""
    own: dict[str, list[list[str]]] = {}
    for names, value in (*local_values(file), *of_module(file)):
        for each in names if is_action(value, file) else ():
            own.setdefault(each, []).append(names)
    stored = Counter(node.id for node in nodes_of_kind(file.tree, ast.Name) if is_stored(node))
    given = {each.arg for each in nodes_of_kind(file.tree, ast.arg)}
    for target, handler in targets:
        bound = own.get(target.id, [])
        if bound and len(bound) == stored[target.id] and target.id not in given:
            yield [each for names in bound for each in names], handler
