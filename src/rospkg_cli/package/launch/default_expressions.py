"""What Python expressions of a launch file are with the defaults of its arguments and a bare environment."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from ...languages.python.nodes import last_name, nodes_of
from ...ros.distros import DISTROS
from .asked_defaults import FALSE, TRUE, Defaults
from .default_helpers import Helpers, value_of_call
from .plain_values import NotKnownError, plain_value

MAX_STEPS = 12
"""Names that are bound to one another, at most."""
PERFORMING = frozenset({"perform_substitutions", "perform_typed_substitution"})
Bound = Mapping[str, ast.expr]


def bound_once(part: ast.AST) -> dict[str, ast.expr]:
    """Return what a function, or the module, binds to names that it binds once."""
    found: dict[str, ast.expr | None] = {}
    for node in nodes_of(part):
        if isinstance(node, ast.arg):
            found[node.arg] = None
        elif isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            name = node.targets[0].id
            found[name] = None if name in found else node.value
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.setdefault(node.id, None)
    return {name: value for name, value in found.items() if value is not None}


class Values:
    """What expressions of Python are with the defaults of the arguments and a bare environment."""

    def __init__(self, names: Bound, arguments: Mapping[str, str], helpers: Helpers) -> None:
        self.names, self.helpers = names, helpers
        self.defaults = Defaults(arguments)
        self.steps = 0

    def truth(self, test: ast.expr) -> tuple[bool | None, str]:
        """Return what a condition is, None where it is not known, and what would make it another."""
        try:
            found = {self.truth_on(each.name, test) for each in DISTROS}
        except NotKnownError:
            return None, ""
        return (found.pop(), self.defaults.other()) if len(found) == 1 else (None, "")

    def truth_on(self, distribution: str, test: ast.expr) -> bool:
        """Return what a condition is on a distribution; raises NotKnownError."""
        self.defaults, self.steps = Defaults(self.defaults.arguments, {}, distribution, ast.unparse(test)), 0
        return bool(plain_value(test, self.known))

    def known(self, node: ast.expr) -> object:
        """Return what a name, a call or an item is; raises NotKnownError."""
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise NotKnownError
        match node:
            case ast.Name(id=name) if name in self.names:
                return plain_value(self.names[name], self.known)
            case ast.Call(func=ast.Attribute(value=of, attr="perform")):
                return self.configured(of)
            case ast.Call(func=ast.Attribute(attr="perform_substitution"), args=[of]):
                return self.configured(of)
            case ast.Call(func=function, args=[_, ast.List(elts=[of])]) if last_name(function) in PERFORMING:
                return self.configured(of)
            case ast.Call(func=ast.Attribute(value=of, attr="evaluate")):
                return self.evaluated(of)
            case (
                ast.Subscript(value=ast.Attribute(attr="launch_configurations"), slice=ast.Constant(value=str(name)))
                | ast.Call(
                    func=ast.Attribute(value=ast.Attribute(attr="launch_configurations"), attr="get"),
                    args=[ast.Constant(value=str(name)), *_],
                )
            ):
                return self.defaults.argument(name)
            case ast.Call(func=function, args=[ast.Constant(value=str(name)), *rest]) if is_environment(function):
                fallback = plain_value(rest[0], self.known) if rest else None
                return self.defaults.variable(name, fallback if isinstance(fallback, str) else None)
            case ast.Subscript(value=of, slice=ast.Constant(value="ROS_DISTRO" as name)) if last_name(of) == "environ":
                return self.defaults.variable(name, None)
            case ast.Attribute(value=ast.Name(id="sys"), attr="argv"):
                self.defaults.asked.setdefault("", "")
                return []
            case ast.Call():
                return value_of_call(node, self.helpers, self.known)
        raise NotKnownError

    def resolved(self, node: ast.expr) -> ast.expr:
        """Return the expression that a name is bound to, or the expression itself."""
        while isinstance(node, ast.Name) and node.id in self.names and self.steps <= MAX_STEPS:
            node, self.steps = self.names[node.id], self.steps + 1
        return node

    def configured(self, node: ast.expr) -> object:
        """Return what `LaunchConfiguration('sim').perform(context)` gives."""
        match self.resolved(node):
            case ast.Call(func=function, args=[ast.Constant(value=str(name)), *_]) if (
                last_name(function) == "LaunchConfiguration"
            ):
                return self.defaults.argument(name)
        raise NotKnownError

    def evaluated(self, node: ast.expr) -> bool:
        """Return what `IfCondition(LaunchConfiguration('sim')).evaluate(context)` gives."""
        match self.resolved(node):
            case ast.Call(func=function, args=[of]) if last_name(function) in ("IfCondition", "UnlessCondition"):
                word = str(self.configured(of)).lower()
                if word in TRUE | FALSE:
                    return (word in TRUE) is (last_name(function) == "IfCondition")
        raise NotKnownError


def is_environment(function: ast.expr) -> bool:
    """Return whether a function gives a variable of the environment: `os.environ.get`, `os.getenv`."""
    match function:
        case ast.Attribute(value=of, attr="get"):
            return last_name(of) == "environ"
    return last_name(function) == "getenv"
