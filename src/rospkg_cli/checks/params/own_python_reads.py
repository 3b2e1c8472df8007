"""Whose parameters Python code gets: those of its own node, of another one, or of one whose base class is elsewhere."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ..python.named_definitions import closed_classes, is_open

NODE = regex(r"node|parent|shared_from_this|^this$|^nh?_?$|^lock$|^self$", re.IGNORECASE)
"""What is in the name of a variable that holds the node, or of a function that returns it."""
CLIENT = regex("client", re.IGNORECASE)
DECLARES = ("declare_parameter", "declare_parameters")
KNOWN = frozenset({"rclpy", "tf2_ros", "message_filters", "image_transport_py", "diagnostic_updater", "cv_bridge"})
"""What gets a node and declares nothing, but under names that are known."""


@dataclass(frozen=True)
class OwnPythonReads:
    files: Sequence[PythonFile]

    def is_of_others(self, file: PythonFile, start: int) -> bool:
        """Return whether a call, whose first argument begins at a place, asks an object that is no node of the code."""
        owner = self.owners(file).get(start)
        name = owner[0] if owner is not None else "self"
        if NODE.search(name) and not CLIENT.search(name):
            return False
        return name not in self.declaring

    def may_inherit(self, file: PythonFile, start: int) -> bool:
        """Return whether the class around such a call has a base class elsewhere, which may declare more."""
        name, around = self.owners(file).get(start, ("", None))
        return name == "self" and around is not None and (not around.bases or is_open(file, around, self.closed))

    def owners(self, file: PythonFile) -> dict[int, tuple[str, ast.ClassDef | None]]:
        """Return by the place of the first argument of each read: the last name of its object, and the class around."""
        known = vars(file)
        if "owners_of_reads" not in known:
            known["owners_of_reads"] = dict(owners_in(file))
        found: dict[int, tuple[str, ast.ClassDef | None]] = known["owners_of_reads"]
        return found

    @cached_property
    def declaring(self) -> frozenset[str]:
        """The names of the objects whose parameters code declares."""
        calls = (call.func for file in self.files for call in nodes_of_kind(file.tree, ast.Call))
        found = (each.value for each in calls if isinstance(each, ast.Attribute) and each.attr in DECLARES)
        return frozenset(filter(None, map(last_name, found)))

    @cached_property
    def closed(self) -> frozenset[str]:
        return closed_classes(self.files)


def owners_in(file: PythonFile) -> Iterator[tuple[int, tuple[str, ast.ClassDef | None]]]:
    around = {id(each): owner for owner in nodes_of_kind(file.tree, ast.ClassDef) for each in ast.walk(owner)}
    for call in nodes_of_kind(file.tree, ast.Call):
        if isinstance(call.func, ast.Attribute) and call.func.attr.startswith("get_parameter") and call.args:
            yield file.span(call.args[0]).start, (last_name(call.func.value), around.get(id(call)))


def hands_itself(file: PythonFile, owner: ast.ClassDef, own: frozenset[str]) -> bool:
    """Return whether a class hands `self` to a function or class of a module that is neither own nor well-known."""
    modules = dict(imported_names(file))
    for call in nodes_of_kind(owner, ast.Call):
        if any(isinstance(each, ast.Name) and each.id == "self" for each in call.args):
            module = modules.get(ast.unparse(call.func).partition(".")[0], "")
            if module and not is_known(module, own):
                return True
    return False


def modules_of(paths: Iterable[str]) -> frozenset[str]:
    """Return the dotted names of the modules that are at some paths, with any folders before them left away."""
    found = set[str]()
    for path in paths:
        parts = path.removesuffix(".py").removesuffix("/__init__").split("/")
        found |= {".".join(parts[at:]) for at in range(len(parts))} if path.endswith(".py") else set()
    return frozenset(found)


def is_known(module: str, own: frozenset[str]) -> bool:
    root = module.partition(".")[0]
    return root in KNOWN or root in sys.stdlib_module_names or module in own


def imported_names(file: PythonFile) -> Iterator[tuple[str, str]]:
    """Yield the names that imports of other packages bind, with the modules that they are of."""
    for each in nodes_of_kind(file.tree, ast.Import):
        yield from ((name.asname or name.name.partition(".")[0], name.name) for name in each.names)
    for one in nodes_of_kind(file.tree, ast.ImportFrom):
        if not one.level and one.module:
            yield from ((name.asname or name.name, one.module) for name in one.names)
