"""Methods of objects that a package creates and never uses: only their own construction may call them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_below, nodes_of_kind
from ...languages.python.unread_values import never_added
from ...light_dataclasses import dataclass
from ...source import Span
from ..python.run_imports import RunImports

PLAIN = frozenset({"object", "ABC", "abc.ABC"})
"""Base classes that call no method by themselves."""
ASKING = frozenset({"hasattr", "isinstance", "super", "type", "id"})
"""What takes an object and calls no method of it."""
MAX_BASES = 10


@dataclass(frozen=True)
class IdleObjects:
    run: RunImports

    def has(self, path: str, span: Span) -> bool:
        """Return whether a place is in a method of a class whose objects are all bound to names that nothing reads.

        The construction of the object must not reach the method either.
        """
        file = self.run.modules.at(path)
        for owner, method in methods_of(file) if file is not None else ():
            at = file.span(method) if file is not None else span
            if at.holds(span):
                return self.is_idle(owner) and method.name not in self.constructed(owner, {method.name})
        return False

    @cached_property
    def classes(self) -> dict[str, list[ast.ClassDef]]:
        """All classes of the package by their names."""
        found: dict[str, list[ast.ClassDef]] = {}
        for _, file in self.run.files:
            for each in nodes_of_kind(file.tree, ast.ClassDef):
                found.setdefault(each.name, []).append(each)
        return found

    def is_idle(self, owner: ast.ClassDef) -> bool:
        """Return whether a class is used, and each use makes an object that nothing reads."""
        if len(self.classes.get(owner.name, ())) != 1 or owner.decorator_list:
            return False
        uses = [is_lost for _, file in self.run.files for is_lost in uses_of(owner, file)]
        return bool(uses) and all(uses)

    def constructed(self, owner: ast.ClassDef, every: set[str]) -> set[str]:
        """Return the methods that the special methods of a class call; `every` where that is not known."""
        methods: dict[str, list[FunctionNode]] = {}
        for base in self.with_bases(owner):
            for each in base.body:
                if isinstance(each, FunctionNode):
                    methods.setdefault(each.name, []).append(each)
        found = {name for name in methods if name.startswith("__")}
        waiting = list(found)
        while waiting:
            for method in methods[waiting.pop()]:
                if hands_itself_on(method):
                    return every
                named = {node.attr for node in nodes_below(method) if isinstance(node, ast.Attribute)}
                waiting += [each for each in named & methods.keys() if each not in found]
                found |= named & methods.keys()
        return found if methods else every

    def with_bases(self, owner: ast.ClassDef) -> list[ast.ClassDef]:
        """Return a class and its base classes; nothing where one of them is not of this package."""
        found, waiting = list[ast.ClassDef](), [owner]
        while waiting:
            each = waiting.pop()
            found.append(each)
            names = [name for base in each.bases if (name := ast.unparse(base)) not in PLAIN]
            known = [self.classes.get(name.rpartition(".")[2], []) for name in names]
            if len(found) > MAX_BASES or each.keywords or any(len(one) != 1 for one in known):
                return []
            waiting += [one[0] for one in known]
        return found


def methods_of(file: PythonFile) -> Iterator[tuple[ast.ClassDef, FunctionNode]]:
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        yield from ((owner, each) for each in owner.body if isinstance(each, FunctionNode))


def uses_of(owner: ast.ClassDef, file: PythonFile) -> Iterator[bool]:
    """Yield of each use of a class outside of it whether it makes an object that nothing reads."""
    if owner.name not in file.source.text:
        return
    own = {id(node) for node in nodes_below(owner)}
    lost = set(never_added(file))
    made = {id(call.func) for call in nodes_of_kind(file.tree, ast.Call) if file.span(call) in lost}
    for node in nodes_below(file.tree):
        match node:
            case ast.Name(id=name) | ast.Attribute(attr=name) | ast.Constant(value=str(name)):
                if name == owner.name and id(node) not in own:
                    yield id(node) in made
            case ast.alias(name=name, asname=str()) if name == owner.name:
                yield False


def hands_itself_on(method: FunctionNode) -> bool:
    """Return whether a method gives its object to something else, which may call any method."""
    first = method.args.args[0].arg if method.args.args else ""
    held = {id(node.value) for node in nodes_below(method) if isinstance(node, ast.Attribute)}
    for node in nodes_below(method):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ASKING:
            held.update(map(id, node.args))
    return any(isinstance(n, ast.Name) and n.id == first and id(n) not in held for n in nodes_below(method))
