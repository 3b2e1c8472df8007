"""Calls of rclpy, of nodes, and of the package's own classes with arguments that these do not take (DEP120)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import guarded_nodes
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.own_reads import own_calls
from ...languages.python.unreached_places import is_unreached
from ...light_dataclasses import dataclass
from ...ros.python_calls import OF_NODES, OF_RCLPY
from ..python.wrong_calls import CATCHES, wrong_call
from ..refused_own_calls import RefusedOwnCalls
from ..repository.older_distribution import OlderDistribution
from .unknown_names_of_rclpy_module import rebinds
from .unknown_rclpy_names import UnknownName, UnknownRclpyNames, name_of

Called = ast.Attribute | ast.Name
"""A method, or a class whose `__init__` is called."""

SINCE_ELOQUENT = "needs `qos_profile` as well"
"""The message on calls that only Dashing and older distributions accept."""
FOR_OLDER = "; the distributions that this is for take it"
"""The end of the message where the repository is for these alone: there the run goes on."""


@dataclass(frozen=True, slots=True)
class WrongRclpyCall:
    called: UnknownName
    """What is called."""
    why: str
    is_for_older: bool = False
    """Whether the repository is for distributions alone that take the call."""


@dataclass(frozen=True)
class WrongRclpyCalls:
    names: UnknownRclpyNames
    distribution: OlderDistribution
    refused: RefusedOwnCalls

    def all(self) -> Iterator[WrongRclpyCall]:
        """Yield each wrong call of a file once for each function and each fault of it."""
        for role, file in self.names.files:
            caught = frozenset(guarded_nodes(file.tree.body, CATCHES))
            seen: set[tuple[str, str]] = set()
            for call, method, why in (*of_module(file), *self.of_nodes(file), *self.of_own(file)):
                is_met = id(call) not in caught and not is_unreached(file, file.span(call))
                if why and is_met and (name_of(method), why) not in seen:
                    seen.add((name_of(method), why))
                    owner = ast.unparse(method.value) if isinstance(method, ast.Attribute) else ""
                    called = self.names.unknown(file, method, owner, "", is_test=role == "test")
                    is_older = why == SINCE_ELOQUENT and self.distribution.is_only_before_eloquent
                    yield WrongRclpyCall(called, why, is_older)

    def of_nodes(self, file: PythonFile) -> Iterator[tuple[ast.Call, ast.Attribute, str]]:
        for owner in self.names.node_classes(file):
            for call, method in own_calls(owner):
                if method.attr in OF_NODES and method.attr not in self.names.defined:
                    yield call, method, wrong_call(call, OF_NODES[method.attr])

    def of_own(self, file: PythonFile) -> Iterator[tuple[ast.Call, Called, str]]:
        """Yield the calls that classes of the package and their objects do not accept."""
        for call, why in self.refused.calls(file):
            if isinstance(call.func, Called):
                yield call, call.func, why


def of_module(file: PythonFile) -> Iterator[tuple[ast.Call, ast.Attribute, str]]:
    if not any(each.module == "rclpy" and not each.names for each in file.imports) or rebinds(file):
        return
    for call in nodes_of_kind(file.tree, ast.Call):
        match call.func:
            case ast.Attribute(value=ast.Name(id="rclpy"), attr=name) as method if name in OF_RCLPY:
                yield call, method, wrong_call(call, OF_RCLPY[name])
