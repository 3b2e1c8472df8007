"""Robot descriptions that launch_ros would read as YAML: a command's output that no ParameterValue calls a text."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ...languages.python.evaluate.values import Call, Mapping, Sequence, Text, Value
from ...languages.python.file import PythonFile
from ...source import Span
from .text import LaunchText, Literal
from .values import class_of, text_of

DESCRIBES = ("xacro", ".urdf")
ROBOT = re.compile(r"([\w.-]+\.(?:xacro|urdf))\b(?!\.)")
TAKERS = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "ComposableNode"})


@dataclass(frozen=True, slots=True)
class Unquoted:
    parameter: str
    span: Span
    """Of the value in the dict where that can be told, else of the command."""
    written: bool
    """Whether the value stands there, so that it can be wrapped."""
    robot: str = ""
    """The name of the file that the command prints, where it is literal."""


def unquoted_in(file: PythonFile, calls: Iterable[Call]) -> Iterator[Unquoted]:
    """Yield the parameters of nodes whose value is the bare output of a command that prints a robot."""
    seen = set()
    dicts = {file.span(node): node for node in ast.walk(file.tree) if isinstance(node, ast.Dict)}
    for call in calls:
        given = call.get("parameters") if class_of(call) in TAKERS else None
        for item in given.items if isinstance(given, Sequence) else ():
            if isinstance(item, Mapping):
                for each in of_dict(file, item, dicts.get(item.span)):
                    if each.span not in seen:
                        seen.add(each.span)
                        yield each


def of_dict(file: PythonFile, given: Mapping, node: ast.Dict | None) -> Iterator[Unquoted]:
    for key, value in given.items.values():
        if isinstance(key, Text) and prints_robot(value):
            place = place_of(key.text, node)
            span = file.span(place) if place else value.span
            yield Unquoted(key.text, span, place is not None, robot_of(value))


def prints_robot(value: Value) -> bool:
    if isinstance(value, Sequence) and len(value.items) == 1:
        value = value.items[0]
    if not isinstance(value, Call) or class_of(value) != "Command":
        return False
    return any(word in piece for piece in pieces(text_of(value)) for word in DESCRIBES)


def robot_of(value: Value) -> str:
    """Return the name of the robot file in a command."""
    names = [found for piece in pieces(text_of(value)) for found in ROBOT.findall(piece)]
    return names[0] if len(names) == 1 else ""


def pieces(text: LaunchText) -> Iterator[str]:
    """Yield the literal texts of a command, also of the programs that it looks for."""
    for part in text.parts:
        if isinstance(part, Literal):
            yield part.text
        elif part.name in ("command", "find-exec"):
            for argument in part.arguments:
                yield from pieces(argument)


def place_of(name: str, node: ast.Dict | None) -> ast.expr | None:
    for key, value in zip(node.keys, node.values, strict=True) if node else ():
        if isinstance(key, ast.Constant) and key.value == name:
            return value
    return None
