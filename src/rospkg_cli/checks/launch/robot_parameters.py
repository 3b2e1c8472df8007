"""Parameters of nodes that hold a robot description, as the output of a command."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, Mapping, Sequence, Text, Value
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.never_launched import never_launched
from ...package.launch.python_to_text import text_of
from ...package.launch.text import LaunchText, Literal
from ...package.launch.uncalled_functions import uncalled_functions
from ...source import Span

PRINTS_ROBOT = ("xacro", ".urdf")
ROBOT_FILE = regex(r"(?<![\w.-])([\w.-]+\.(?:xacro|urdf))\b(?!\.)")
NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "ComposableNode"})


@dataclass(frozen=True, slots=True)
class RobotParameter:
    """A parameter of a node whose value is the bare output of a command that prints a robot."""

    parameter: str
    span: Span
    """Of the value in the dict where it is written there, else of the command."""
    is_in_dict: bool
    """Whether the value is written in the dict, so that it can be wrapped."""
    robot: str = ""
    """The name of the file that the command prints, where it is literal."""


def robot_parameters(launch: EvaluatedLaunch) -> Iterator[RobotParameter]:
    """Yield each place once; what a node gets that nothing adds to the launch description is never evaluated."""
    seen, file = set(), launch.file
    idle = (*never_launched(file), *uncalled_functions(file))
    dicts = {file.span(node): node for node in nodes_of_kind(file.tree, ast.Dict)}
    for call in launch.calls:
        is_node = class_of(call) in NODES and not any(each.contains(call.span) for each in idle)
        given = call.get("parameters") if is_node else None
        for item in given.items if isinstance(given, Sequence) else ():
            if isinstance(item, Mapping):
                for each in parameters_in(file, item, dicts.get(item.span)):
                    if each.span not in seen:
                        seen.add(each.span)
                        yield each


def parameters_in(file: PythonFile, given: Mapping, node: ast.Dict | None) -> Iterator[RobotParameter]:
    for key, value in given.items.values():
        if isinstance(key, Text) and prints_robot(value):
            written = written_value(key.text, node)
            span = file.span(written) if written else value.span
            yield RobotParameter(key.text, span, written is not None, robot_of(value))


def prints_robot(value: Value) -> bool:
    if isinstance(value, Sequence) and len(value.items) == 1:
        value = value.items[0]
    if not isinstance(value, Call) or class_of(value) != "Command":
        return False
    return any(word in piece for piece in pieces(text_of(value)) for word in PRINTS_ROBOT)


def robot_of(value: Value) -> str:
    """Return the name of the robot file in a command."""
    names = [found for piece in pieces(text_of(value)) for found in ROBOT_FILE.findall(piece)]
    return names[0] if len(names) == 1 else ""


def pieces(text: LaunchText) -> Iterator[str]:
    """Yield the literal texts of a command, also of the programs that it looks for."""
    for part in text.parts:
        if isinstance(part, Literal):
            yield part.text
        elif part.name in ("command", "find-exec"):
            for argument in part.arguments:
                yield from pieces(argument)


def written_value(name: str, node: ast.Dict | None) -> ast.expr | None:
    """Return the value of a key in a dict of the source."""
    for key, value in zip(node.keys, node.values, strict=True) if node else ():
        if isinstance(key, ast.Constant) and key.value == name:
            return value
    return None
