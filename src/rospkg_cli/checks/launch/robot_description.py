"""LCH009: the output of a command as a parameter, which launch_ros reads as YAML: robot descriptions.

A `ParameterValue(…, value_type=str)` around it makes it a string.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.python.evaluate.values import Call, Mapping, Sequence, Text, Value
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_launched
from ...package.launch.python_to_text import text_of
from ...package.launch.text import LaunchText, Literal
from ...package.launch.uncalled_functions import uncalled_functions
from ...source import Span

PRINTS_ROBOT = ("xacro", ".urdf")
ROBOT_FILE = regex(r"(?<![\w.-])([\w.-]+\.(?:xacro|urdf))\b(?!\.)")
NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "ComposableNode"})

COMMENT = r"<!--(?:(?!-->).){0,5000}-->[ \t\r]{0,200}\n?[ \t]{0,200}"
DROPPED = regex(rf"(?:{COMMENT}){{1,20}}(?=<xacro:)|<xacro:[^<>]*>", re.DOTALL)
"""What xacro leaves out: its own elements, and the comments right before them. (xacro: remove_previous_comments)"""

NO_PLAIN_SCALAR = regex(r":[ \t\r\n]|[ \t]#")
"""What ends a plain scalar of YAML: a colon with a blank behind it, a hash with a blank before it."""

HEADER = regex(rf"\s*(?:<\?xml[^>]*>\s*)?(?:{COMMENT})*", re.DOTALL)
"""What stands before the root element."""

INCLUDED = regex(r"filename\s*=\s*[\"'][^\"']*?([\w.-]+\.(?:xacro|urdf|xml))[\"']")


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


@dataclass(frozen=True)
class RobotDescriptions:
    """The robot parameters of the launch files of a package, and its robot files."""

    launch: tuple[LaunchFile, ...]
    files: PackageFiles

    def parameters(self) -> Iterator[tuple[LaunchFile, RobotParameter, str]]:
        """Yield each parameter with the file of the package that YAML can't read; "" where none is known."""
        for file in self.launch:
            for each in robot_parameters(file.evaluated) if file.evaluated else ():
                yield file, each, next(self.files_unlike_yaml(each.robot), "")

    def files_unlike_yaml(self, name: str) -> Iterator[str]:
        """Yield the files of a robot that hold what YAML can't read, from the one of this name on."""
        seen, queue = {name}, [name] if name.endswith((".xacro", ".urdf")) else []
        while queue:
            current = queue.pop()
            for path in self.files.paths:
                if path.rpartition("/")[2] == current:
                    text = self.files.readable_text(path)
                    if NO_PLAIN_SCALAR.search(printed(text if current == name else root_of(text))):
                        yield path
                    found = [each for each in INCLUDED.findall(text) if each not in seen]
                    seen.update(found)
                    queue += found


def root_of(text: str) -> str:
    """Return a file from its root element on: xacro includes nothing of what stands before it (process_include)."""
    header = HEADER.match(text)
    return text[header.end() :] if header else text


def printed(text: str) -> str:
    """Return what xacro prints of a file, as far as it passes over comments and its own elements."""
    return DROPPED.sub("", text) if "<xacro:" in text else text


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
