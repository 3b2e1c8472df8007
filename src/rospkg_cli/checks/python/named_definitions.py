"""The functions, methods and classes of a file, each with what it leads to by names."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...light_dataclasses import dataclass
from .node_bases import is_of_rclpy, origins
from .own_names import own_names

Definition = FunctionNode | ast.ClassDef
OF_NODES = frozenset({"Node", "LifecycleNode"})
EMPTY = frozenset({"object", "ABC", "Protocol"})
CALLED_BY_ROS = ("__", "on_", "destroy_node", "generate_")
"""How methods and functions begin that Python or ROS calls by itself."""


@dataclass(frozen=True, slots=True)
class Named:
    """A definition, and what it leads to where something leads to it."""

    node: Definition
    names: frozenset[str]
    """That its own code mentions, without the definitions in it."""
    by_others: tuple[Named, ...]
    """The methods of a class that code of others may call by their names, once there is an object."""
    owner: str
    """The class that it is a member of; "" for none."""
    around: str
    """The class whose object `self` is in it."""


def definitions(file: PythonFile, off: Collection[int], closed: Collection[str] = ()) -> Iterator[Named]:
    """Yield the definitions of a file, wherever they stand; `closed` are classes whose methods no other code calls."""
    found: dict[int, Named] = {}
    nodes = [each for each in nodes_of(file.tree) if isinstance(each, Definition)]
    owners = [each for each in nodes if isinstance(each, ast.ClassDef)]
    owned = {id(inner): each.name for each in owners for inner in each.body}
    around = {id(inner): each.name for each in owners for inner in nodes_of(each)}  # the innermost one comes last
    for node in reversed(nodes):
        called: tuple[Named, ...] = ()
        if isinstance(node, ast.ClassDef):
            inner = [found[id(each)] for each in node.body if id(each) in found]
            is_free = is_open(file, node, closed)
            called = tuple(each for each in inner if is_free or each.node.name.startswith(CALLED_BY_ROS))
        names, here = frozenset(own_names(file, node, off)), (owned.get(id(node), ""), around.get(id(node), ""))
        found[id(node)] = Named(node, names, called, *here)
    yield from found.values()


def takes_no_object(each: Named) -> bool:
    """Return whether this is a method without `self`: who has an object can't call it."""
    node = each.node
    return bool(each.owner) and isinstance(node, FunctionNode) and not ast.unparse(node.args)


def is_open(file: PythonFile, node: ast.ClassDef, closed: Collection[str]) -> bool:
    """Return whether code of others may call the methods of a class: it has a base of theirs, but for a node's."""
    last = {ast.unparse(base).rpartition(".")[2] for base in node.bases if not is_plain_node(file, base)}
    return bool(last - EMPTY - frozenset(closed)) or bool(node.keywords)


def is_plain_node(file: PythonFile, base: ast.expr) -> bool:
    """Return whether a base is rclpy's node, or is called so in a file that takes no such name from elsewhere."""
    text = ast.unparse(base)
    is_called_so = text.rpartition(".")[2] in OF_NODES
    return is_of_rclpy(file, base) or (is_called_so and not origins(file, text.partition(".")[0]))


def closed_classes(files: Iterable[PythonFile]) -> frozenset[str]:
    """Return the names of the classes that have no base but own ones, nodes and the empty ones of Python."""
    every: dict[str, list[tuple[PythonFile, ast.ClassDef]]] = {}
    for file in files:
        for node in nodes_of_kind(file.tree, ast.ClassDef):
            every.setdefault(node.name, []).append((file, node))
    closed, before = frozenset[str](), -1
    while len(closed) > before:
        before = len(closed)
        closed = frozenset(name for name, nodes in every.items() if not any(is_open(*each, closed) for each in nodes))
    return closed
