"""The defaults of a launch file's arguments, and which of them the evaluation of a condition asked for."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from ...light_dataclasses import dataclass, field
from .plain_values import NotKnownError

FALSE = frozenset({"false", "0"})
TRUE = frozenset({"true", "1"})
OF_ROS = frozenset({"ROS_DISTRO", "ROS_VERSION", "AMENT_PREFIX_PATH", "HOME", "USER", "PATH", "PWD", "DISPLAY"})
"""Variables that nearly every environment has."""


@dataclass
class Defaults:
    """The defaults, and what was asked for so far."""

    arguments: Mapping[str, str]
    asked: dict[str, str] = field(default_factory=dict)
    """Each argument (`sim:=`) or variable (`SIM=`) that a value depends on, with its default."""
    distribution: str = ""
    """The distribution of ROS; "" where it is not known."""
    expression: str = ""
    """The last expression of Python that was evaluated, or what would say the same."""

    def argument(self, name: str, fallback: str | None = None) -> str:
        found = self.arguments.get(name, fallback)
        if found is None:
            raise NotKnownError
        self.asked.setdefault(f"{name}:=", found)
        return found

    def variable(self, name: str, fallback: str | None) -> str | None:
        if name == "ROS_DISTRO" and self.distribution:
            self.asked.setdefault(f"{name}=", self.distribution)
            return self.distribution
        if name in OF_ROS:
            raise NotKnownError
        self.asked.setdefault(f"{name}=", fallback or "")
        return fallback

    def other(self) -> str:
        """Return the first thing that was asked for, with a value that is not its default: `sim:=true`; "" for none."""
        if not self.asked:
            return ""
        name, default = next(iter(self.asked.items()))
        found = compared_with(self.expression, default)
        opposite = str(default.lower() in FALSE).lower() if default.lower() in FALSE | TRUE else "…"
        return f"{name}{found or opposite}"


def compared_with(expression: str, default: str) -> str:
    """Return a text that an expression compares something with and that is not the default; "" for none."""
    try:
        nodes = list(ast.walk(ast.parse(expression.strip(), mode="eval")))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    operands = [each for node in nodes if isinstance(node, ast.Compare) for each in (node.left, *node.comparators)]
    lists = [item for each in operands if isinstance(each, ast.List | ast.Tuple | ast.Set) for item in each.elts]
    words = [each.value for each in (*operands, *lists) if isinstance(each, ast.Constant)]
    return next((word for word in words if isinstance(word, str) and word not in ("", default)), "")
