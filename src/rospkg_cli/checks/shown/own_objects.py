"""Which own classes objects are of, and which functions their members mean."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, functions_of, nodes_of_kind
from ...light_dataclasses import dataclass
from ...ros.rclpy_names import members_of_nodes
from .meanings import Meanings, Own

OF_OTHERS = frozenset(
    "run start stop close open read write send recv receive join put get publish call spin wait connect disconnect "
    "destroy shutdown acquire release reset step plot show save load fit predict update execute process main setup "
    "init cancel result submit notify register draw render forward move set add remove clear push flush exec".split()
)
"""Names that objects of other packages have, too."""
OF_PYTHON = frozenset(name for kind in (list, dict, set, str, bytes, int, float) for name in dir(kind))


@dataclass(frozen=True)
class OwnObjects:
    meanings: Meanings

    @cached_property
    def classes(self) -> tuple[Own, ...]:
        files = (file for _, file in self.meanings.run.files)
        return tuple(Own(file, each) for file in files for each in nodes_of_kind(file.tree, ast.ClassDef))

    @cached_property
    def lines(self) -> dict[int, tuple[Own, ...]]:
        return {}

    def line(self, owner: Own) -> tuple[Own, ...]:
        """Return a class with its own bases, in the order in which Python looks for members, as a rule."""
        if owner.key not in self.lines:
            self.lines[owner.key] = (owner,)  # for a circle
            bases = owner.node.bases if isinstance(owner.node, ast.ClassDef) else []
            definition = [self.meanings.of(owner.file, each) for each in bases]
            above = [one for each in definition if each is not None for one in self.line(each)]
            self.lines[owner.key] = (owner, *above)
        return self.lines[owner.key]

    @cached_property
    def heirs(self) -> dict[int, list[Own]]:
        found: dict[int, list[Own]] = {}
        for each in self.classes:
            for base in self.line(each)[1:]:
                found.setdefault(base.key, []).append(each)
        return found

    def own_member(self, owner: Own, name: str) -> Own | None:
        return self.members.get((owner.key, name))

    @cached_property
    def members(self) -> dict[tuple[int, str], Own]:
        """The functions of each class, by the class and the name."""
        return {(each.key, one.name): Own(each.file, one) for each in self.classes for one in functions_in(each)}

    def member(self, owner: Own, name: str, *, above: bool = False) -> Own | None:
        """Return the function that a class has under a name, by itself or by a base; one of a base for `super()`."""
        found = (self.own_member(each, name) for each in self.line(owner)[int(above) :])
        return next((each for each in found if each is not None), None)

    @cached_property
    def having(self) -> dict[str, list[Own]]:
        """The classes that have a function of a name by themselves."""
        found: dict[str, list[Own]] = {}
        for each in self.classes:
            for one in functions_in(each):
                found.setdefault(one.name, []).append(each)
        return found

    def alone(self, name: str) -> list[Own]:
        """Return the classes that a member of an unknown object may be of, where these are of one family."""
        is_common = name.startswith("__") or name in OF_OTHERS or name in OF_PYTHON or name in members_of_nodes()
        found = [] if is_common else self.having.get(name, [])
        first = [each for each in found if len(self.line(each)) == 1]
        is_one = len(found) == 1 or (len(first) == 1 and all(first[0] in self.line(each) for each in found))
        return found if is_one else []

    @cached_property
    def attributes(self) -> dict[str, list[Own]]:
        """The classes of what is set as an attribute of an object: `self.arm = Arm()`."""
        found: dict[str, list[Own]] = {}
        for _, file in self.meanings.run.files:
            for target, value in stores(file):
                made = self.made_by(file, value) if isinstance(target, ast.Attribute) else None
                if made is not None and isinstance(target, ast.Attribute):
                    found.setdefault(target.attr, []).append(made)
        return found

    @cached_property
    def of_files(self) -> dict[str, dict[str, list[Own]]]:
        return {}

    def variables(self, file: PythonFile) -> dict[str, list[Own]]:
        """Return the classes of a file's variables and parameters, as far as they are shown."""
        if file.path not in self.of_files:
            found: dict[str, list[Own]] = {}
            for target, value in stores(file):
                made = self.made_by(file, value) if isinstance(target, ast.Name) else None
                if made is not None and isinstance(target, ast.Name):
                    found.setdefault(target.id, []).append(made)
            for each in (one for function in functions_of(file.tree) for one in function.args.args):
                definition = self.meanings.of(file, each.annotation) if each.annotation is not None else None
                if definition is not None and isinstance(definition.node, ast.ClassDef):
                    found.setdefault(each.arg, []).append(definition)
            self.of_files[file.path] = found
        return self.of_files[file.path]

    def made_by(self, file: PythonFile, value: ast.expr | None) -> Own | None:
        """Return the class of which an expression makes an object."""
        definition = self.meanings.of(file, value.func) if isinstance(value, ast.Call) else None
        return definition if definition is not None and isinstance(definition.node, ast.ClassDef) else None

    def of(self, file: PythonFile, expression: ast.expr) -> list[Own]:
        """Return the classes of which an expression is an object; none where that is not shown."""
        match expression:
            case ast.Name(id=name):
                return self.variables(file).get(name, [])
            case ast.Attribute(attr=name):
                return self.attributes.get(name, [])
        made = self.made_by(file, expression)
        return [made] if made is not None else []


def stores(file: PythonFile) -> Iterator[tuple[ast.expr, ast.expr | None]]:
    """Yield what a file assigns, with the values."""
    for each in nodes_of_kind(file.tree, ast.Assign):
        yield from ((target, each.value) for target in each.targets)
    for one in nodes_of_kind(file.tree, ast.AnnAssign):
        yield one.target, one.value
    for item in nodes_of_kind(file.tree, ast.withitem):
        if item.optional_vars is not None:
            yield item.optional_vars, item.context_expr


def functions_in(owner: Own) -> Iterator[FunctionNode]:
    """Yield the functions that stand in a class itself."""
    body = owner.node.body if isinstance(owner.node, ast.ClassDef) else []
    return (each for each in body if isinstance(each, FunctionNode))
