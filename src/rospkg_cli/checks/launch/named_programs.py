"""The programs that a launch file starts by package and name: nodes, `ros2 run`, `ExecutableInPackage`."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import Command
from ...package.launch.text import LaunchText, Literal, Substitution
from ...source import Span

RUN = regex(r"\s*ros2\s+run\s+(?P<package>[A-Za-z]\w*)\s+(?P<program>[\w.][\w.-]*)(?=\s|$)")


@dataclass(frozen=True, slots=True)
class NamedProgram:
    package: str
    executable: LaunchText
    span: Span
    """Of what starts it."""
    is_command: bool = False
    """Whether `ros2 run` starts it, without which the launch goes on."""


def named_programs(file: LaunchFile) -> Iterator[NamedProgram]:
    """Yield what is started under literal names; nothing of a file for ROS 1."""
    for package, executable, node in file.programs():
        yield NamedProgram(package, executable, node.span)
    for each in file.substitutions if not file.is_ros1 else ():
        match each:
            case Substitution(name="exec-in-pkg", arguments=(program, home, *_)):
                if program.literal and home.literal:
                    yield NamedProgram(home.literal, program, each.span)
    for command in file.commands if not file.is_ros1 else ():
        yield from run_by(command)


def run_by(command: Command) -> Iterator[NamedProgram]:
    """Yield the program of `ros2 run`, as words of its own or in one text."""
    words = [word.literal or "" for word in command.words]
    if words[:2] == ["ros2", "run"] and all(word and word[0] != "-" for word in words[2:4]) and len(words) > 3:
        yield NamedProgram(words[2], command.words[3], command.span, is_command=True)
    first = command.words[0].parts[0] if len(words) == 1 and command.words[0].parts else None
    found = RUN.match(first.text) if isinstance(first, Literal) else None
    if found is not None and isinstance(first, Literal) and first.span.end - first.span.start == len(first.text):
        start, end = found.span("program")
        span = Span(first.span.start + start, first.span.start + end)
        is_whole = end < len(first.text) or len(command.words[0].parts) == 1
        if is_whole:
            text = LaunchText(span, (Literal(found["program"], span),))
            yield NamedProgram(found["package"], text, command.span, is_command=True)
