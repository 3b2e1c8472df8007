"""Parameters of a package's own functions that every call leaves at a literal default: `def main(plot=False)`."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, defaults_of, functions_of, last_name, nodes_of_kind
from ...languages.python.settled_names import Held, Values, constant_of

START = "__init__"


class LeftDefaults:
    """What parameters always hold, as far as a package's own code calls their functions."""

    def __init__(self, files: Iterable[PythonFile]) -> None:
        self.files = tuple(files)

    def of(self, function: FunctionNode) -> Values:
        """Return the parameters that no call gives, with their defaults; none where something else may call."""
        given, (called, skipped) = literal_defaults(function), self.called.get(id(function), ("", 0))
        if not given or not called or function.decorator_list or self.names.count(called) > 1:
            return {}
        calls = self.calls.get(called, [])
        if called in self.handed or called in self.handed_out or (skipped and not calls):
            return {}
        places = [each.arg for each in (*function.args.posonlyargs, *function.args.args)][skipped:]
        bound = {each.id for each in nodes_of_kind(function, ast.Name) if not isinstance(each.ctx, ast.Load)}
        left = (name for name in given if name not in bound and all(is_left(call, name, places) for call in calls))
        return {name: frozenset({given[name]}) for name in left}

    @cached_property
    def kept(self) -> dict[int, Held]:
        """By each value that a function assigns and that is such a parameter, what it holds: `self.plot = plot`."""
        found: dict[int, Held] = {}
        for file in self.files:
            for function in functions_of(file.tree):
                given = self.of(function)
                for each in nodes_of_kind(function, ast.Assign) if given else ():
                    if isinstance(each.value, ast.Name) and each.value.id in given:
                        found[id(each.value)] = next(iter(given[each.value.id]))
        return found

    @cached_property
    def called(self) -> dict[int, tuple[str, int]]:
        """By each function, the name by which it is called, and how many of its parameters no call writes."""
        found = {id(each): (each.name, 0) for file in self.files for each in functions_of(file.tree)}
        for owner in (each for file in self.files for each in nodes_of_kind(file.tree, ast.ClassDef)):
            for each in owner.body:
                if isinstance(each, FunctionNode):
                    found[id(each)] = (owner.name if each.name == START else each.name, 1)
                    is_magic = each.name.startswith("__") and each.name != START
                    found |= {id(each): ("", 0)} if is_magic or owner.decorator_list else {}
        return found

    @cached_property
    def names(self) -> list[str]:
        """The names of all functions but constructors, and of all classes."""
        functions = (each.name for file in self.files for each in functions_of(file.tree) if each.name != START)
        return [*functions, *(each.name for file in self.files for each in nodes_of_kind(file.tree, ast.ClassDef))]

    @cached_property
    def calls(self) -> dict[str, list[ast.Call]]:
        found: dict[str, list[ast.Call]] = {}
        for file in self.files:
            for call in nodes_of_kind(file.tree, ast.Call):
                found.setdefault(last_name(call.func), []).append(call)
        return found

    @cached_property
    def handed(self) -> frozenset[str]:
        """The names that code mentions without a call, or takes by another name: a callback, a base, an annotation."""
        return frozenset(name for file in self.files for name in mentions(file))

    @cached_property
    def handed_out(self) -> frozenset[str]:
        """The words in strings: `getattr(module, 'main')`."""
        texts = (each.value for file in self.files for each in nodes_of_kind(file.tree, ast.Constant))
        return frozenset(text for text in texts if isinstance(text, str) and text.isidentifier())


def literal_defaults(function: FunctionNode) -> dict[str, Held]:
    """Return the parameters with a literal default."""
    pairs = defaults_of(function.args)
    return {each.arg: held for each, value in pairs if (held := constant_of(value)) is not None}


def is_left(call: ast.Call, name: str, places: list[str]) -> bool:
    """Return whether a call certainly gives no value to a parameter."""
    if any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords):
        return False
    return name not in (*places[: len(call.args)], *(each.arg for each in call.keywords))


def mentions(file: PythonFile) -> Iterator[str]:
    called = {id(call.func) for call in nodes_of_kind(file.tree, ast.Call)}
    for node in (*nodes_of_kind(file.tree, ast.Name), *nodes_of_kind(file.tree, ast.Attribute)):
        if id(node) not in called:
            yield last_name(node)
    aliases = [alias for each in nodes_of_kind(file.tree, ast.ImportFrom) for alias in each.names]
    aliases += [alias for each in nodes_of_kind(file.tree, ast.Import) for alias in each.names]
    yield from (alias.name for alias in aliases if alias.asname not in (None, alias.name))
