"""Programs that launch files put before the command of a node: `prefix='xterm -e'`, `launch-prefix="gdb -ex run"`."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_to_text import text_of
from ...source import Span

PROGRAMS = frozenset({
    "gnome-terminal", "konsole", "screen", "terminator", "tmux", "valgrind", "xterm",
})  # fmt: skip
"""Programs that rosdep has keys for, called like them."""

PROCESSES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "ExecuteProcess", "ExecuteLocal"})


WATCHERS = regex(
    r"(?:^|[\s/])(?:gdb(?:server)?|lldb|rr|valgrind|perf|heaptrack|[lms]trace|kcachegrind|hotspot|py-spy|i?pdb|pdb3)(?=\s|$)"
)
"""Debuggers and profilers, without which a program runs as well."""


@dataclass(frozen=True, slots=True)
class ProgramPrefix:
    program: str
    span: Span
    is_to_watch: bool
    """Whether the process is to be debugged or measured."""


def program_prefixes(file: LaunchFile) -> Iterator[ProgramPrefix]:
    """Yield each program that is named before the command of a process, in plain text and under no condition."""
    for text, span in (*of_entities(file), *of_calls(file)):
        program = text.split(" ")[0].rpartition("/")[2]
        if program in PROGRAMS:
            yield ProgramPrefix(program, span, WATCHERS.search(text) is not None)


def of_entities(file: LaunchFile) -> Iterator[tuple[str, Span]]:
    for entity in file.root.walk() if file.root is not None else ():
        prefix = entity.attributes.get("launch-prefix")
        if prefix is not None and not {"if", "unless"} & entity.attributes.keys():
            yield prefix.text, prefix.span


def of_calls(file: LaunchFile) -> Iterator[tuple[str, Span]]:
    for call in file.evaluated.calls if file.evaluated is not None else ():
        prefix = call.get("prefix") if call.is_certain and class_of(call) in PROCESSES else None
        if prefix is not None and call.get("condition") is None:
            yield text_of(prefix).literal or "", prefix.span
