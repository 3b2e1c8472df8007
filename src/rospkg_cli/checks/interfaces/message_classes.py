"""The classes of messages that a Python file imports, and the messages that its expressions create."""

from __future__ import annotations

import ast
from bisect import bisect_left
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...ros.interfaces import KINDS
from ...ros.python_calls import REEXPORTED

PARTS = {
    "srv": {"Request": "_Request", "Response": "_Response"},
    "action": {"Goal": "_Goal", "Result": "_Result", "Feedback": "_Feedback"},
}
"""The attributes of a service's or an action's class that are messages."""
SHARING = frozenset(each.rpartition("/")[0] for each in REEXPORTED)
"""Modules from which messages of other packages are taken."""


class MessageClasses:
    """By local name what a file imports of interfaces: `package/kind/Name`, or the module `package/kind`."""

    def __init__(self, file: PythonFile) -> None:
        self.file = file
        self.names: dict[str, str] = {}
        self.modules: set[str] = set()
        others: set[str] = set()
        for name, found in bound_names(file):
            if self.names.setdefault(name, found) != found or not found:
                others.add(name)
        for name in others:
            self.names.pop(name, None)
        for node in nodes_of_kind(file.tree, ast.Import):
            self.modules |= {alias.name for alias in node.names if not alias.asname}

    @cached_property
    def _lines(self) -> list[int]:
        """The lines of all names that an interface, or a module of them, is reached by."""
        starts = self.names.keys() | {module.partition(".")[0] for module in self.modules}
        return sorted(node.lineno for node in nodes_of_kind(self.file.tree, ast.Name) if node.id in starts)

    def may_be_named_in(self, node: ast.stmt) -> bool:
        """Return whether a statement may name an interface: most functions of a file need no closer look."""
        at = bisect_left(self._lines, node.lineno)
        return at < len(self._lines) and self._lines[at] <= (node.end_lineno or node.lineno)

    def named(self, node: ast.expr) -> str:
        """Return the interface, the message or the module of interfaces that an expression names; "" for others."""
        if isinstance(node, ast.Name):
            return self.names.get(node.id, "")
        if not isinstance(node, ast.Attribute):
            return ""
        if isinstance(node.value, ast.Name) and f"{node.value.id}.{node.attr}" in self.modules and node.attr in KINDS:
            return f"{node.value.id}/{node.attr}" if not self.names.get(node.value.id) else ""
        outer = self.named(node.value)
        if outer in SHARING:
            return REEXPORTED.get(f"{outer}/{node.attr}", "")
        if outer.count("/") == 1:
            return f"{outer}/{node.attr}"
        kind = outer.split("/")[1] if outer.count("/") == len(("package", "name")) else ""
        suffix = PARTS.get(kind, {}).get(node.attr, "")
        return f"{outer}{suffix}" if suffix else ""

    def message(self, node: ast.expr) -> str:
        """Return the message whose class an expression names; "" for others, and for whole services and actions."""
        found = self.named(node)
        return found if is_message(found) else ""


def is_message(name: str) -> bool:
    if name.count("/") != len(("package", "name")):
        return False
    suffixes = tuple(PARTS.get(name.split("/")[1], {}).values())
    return "/msg/" in name or (bool(suffixes) and name.endswith(suffixes))


def names_interfaces(file: PythonFile) -> bool:
    """Return whether a file imports interfaces, or a module of them, anywhere: without that it has no such class."""
    return any(
        kind in KINDS or (not kind and any(alias.name in KINDS for alias in node.names))
        for node in nodes_of_kind(file.tree, ast.ImportFrom)
        for kind in ((node.module or "").partition(".")[2],)
    ) or any(
        alias.name.partition(".")[2] in KINDS for node in nodes_of_kind(file.tree, ast.Import) for alias in node.names
    )


def bound_names(file: PythonFile) -> Iterator[tuple[str, str]]:
    """Yield every name that is bound somewhere in a file, with the interface it is imported as; "" for others."""
    tree = file.tree
    for each in nodes_of_kind(tree, ast.ImportFrom):
        package, _, kind = (each.module or "").partition(".") if not each.level else ("", "", "")
        for alias in each.names:
            found = f"{package}/{kind}/{alias.name}" if kind in KINDS else ""
            if package and not kind and (alias.name in KINDS or f"{package}/{alias.name}" in SHARING):
                found = f"{package}/{alias.name}"
            found = found or REEXPORTED.get(f"{package}/{kind}/{alias.name}", "")
            yield alias.asname or alias.name, found
    for plain in nodes_of_kind(tree, ast.Import):
        for alias in plain.names:
            package, _, kind = alias.name.partition(".")
            if alias.asname:
                yield alias.asname, f"{package}/{kind}" if kind in KINDS or f"{package}/{kind}" in SHARING else ""
    yield from ((node.name, "") for node in nodes_of_kind(tree, ast.FunctionDef))
    yield from ((node.name, "") for node in nodes_of_kind(tree, ast.AsyncFunctionDef))
    yield from ((node.name, "") for node in nodes_of_kind(tree, ast.ClassDef))
    yield from ((name, "") for name in changed_names(file))
    yield from ((node.id, "") for node in nodes_of_kind(tree, ast.Name) if not isinstance(node.ctx, ast.Load))
    yield from ((node.arg, "") for node in nodes_of_kind(tree, ast.arg))
    yield from ((node.name, "") for node in nodes_of_kind(tree, ast.ExceptHandler) if node.name)


def changed_names(file: PythonFile) -> Iterator[str]:
    """Yield the names of objects whose attributes are set, by `Name.field = …` or setattr(), or whose slots are taken.

    A class that is changed so has other fields than its message.
    """
    yield from (each.id for each in changed(file) if isinstance(each, ast.Name))


def changed(file: PythonFile) -> Iterator[ast.expr]:
    for node in nodes_of_kind(file.tree, ast.Attribute):
        if isinstance(node.ctx, ast.Store) or node.attr == "__slots__":
            yield node.value
    for call in nodes_of_kind(file.tree, ast.Call):
        if isinstance(call.func, ast.Name) and call.func.id == "setattr":
            yield from call.args[:1]


def changed_messages(file: PythonFile) -> frozenset[str]:
    """Return the messages whose classes a file changes: they have other fields in all modules that import them."""
    imported = {name: found for name, found in bound_names(file) if found}
    classes = MessageClasses(file)
    named = (imported.get(each.id, "") if isinstance(each, ast.Name) else classes.named(each) for each in changed(file))
    return frozenset(filter(None, named))
