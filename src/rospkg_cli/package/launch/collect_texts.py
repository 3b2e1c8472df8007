"""Every text that a Python launch file passes to an action, a substitution or a function that reads files."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping as ByName

from ...languages.python.evaluate.values import Call, Mapping, Sequence, Text, Unknown, Value
from ...source import Span
from .file_references import NO_DEFAULTS, FileReference, ReferenceKind, references_in
from .launch_classes import class_of
from .moveit_builder import files_read
from .python_to_text import NAMED, text_of
from .text import LaunchText, Substitution

LISTS = frozenset({
    "arguments", "ros_arguments", "parameters", "cmd", "remappings", "launch_arguments", "actions", "entities",
    "initial_entities", "composable_node_descriptions", "args",
})  # fmt: skip
"""Arguments whose items are separate texts; any other list that launch gets is one text."""
NO_FILES = frozenset({"choices"})
"""Arguments whose texts are compared, and open nothing."""

NO_TEXT = frozenset({
    "LaunchDescription", "GroupAction", "TimerAction", "PathJoinSubstitution", "PathSubstitution", "LogInfo",
})  # fmt: skip
"""Classes that take actions, join texts to a path that is used elsewhere, or only print them."""

READERS = frozenset({"open", "io.open", "codecs.open", "xacro.process_file", "xacro.process", "xacro.parse"})
PATH_TESTS = frozenset({"os.path.exists", "os.path.isfile", "os.path.lexists", "os.access", "os.stat", "os.makedirs"})
PATH_METHODS = frozenset({"exists", "is_file", "write_text", "touch", "open"})
INCLUDING = ("LaunchDescriptionSource", "IncludeLaunchDescription")
PASSED_ON = "launch_arguments"
MAX_DEPTH = 20


def file_references(
    calls: list[Call], folder: str, guarded: tuple[Span, ...], defaults: ByName[str, str]
) -> Iterator[FileReference]:
    """Yield the files that a launch file in `folder` names, except those that it tests or writes.

    Files that are read inside of `guarded`, where a missing file is caught, are left out too.
    """
    bare = [call for call in calls if not any(span.holds(call.span) for span in guarded)]
    return named_by(bare, calls, folder, defaults)


def caught_references(calls: list[Call], folder: str, silent: tuple[Span, ...]) -> Iterator[FileReference]:
    """Yield the files that functions open inside of `silent`, where a missing file is caught without a word."""
    inside = [call for call in calls if call.callee in READERS and any(span.holds(call.span) for span in silent)]
    return named_by(inside, calls, folder, NO_DEFAULTS)


def named_by(some: list[Call], calls: list[Call], folder: str, defaults: ByName[str, str]) -> Iterator[FileReference]:
    """Yield the files that some of the calls name, and that none of all of them tests or writes."""
    found = [
        path for call in some for kind, text in texts_of(call) for path in references_in(text, folder, kind, defaults)
    ]
    asked = {(path.package, path.path) for call in calls for path in tested_paths(call, folder)}
    return (path for path in dict.fromkeys(found) if (path.package, path.path) not in asked)


def kind_of(call: Call) -> ReferenceKind:
    name = class_of(call)
    if call.callee in READERS:
        return "open"
    return "default" if name == "DeclareLaunchArgument" else "include" if name.endswith(INCLUDING) else "file"


def texts_of(call: Call) -> Iterator[tuple[ReferenceKind, LaunchText]]:
    """Yield the texts that are passed to a call; a path that is only joined is not used yet.

    What an included file gets as an argument is not what is included.
    """
    name = class_of(call)
    if name:
        takes = name == "Command" or name not in NAMED.keys() | NO_TEXT
    else:
        takes = call.callee in READERS or call.callee.rpartition(".")[2][:1].isupper()
    if call.receiver is None and takes and not writes(call):
        for argument in call.arguments:
            if argument.name in NO_FILES:
                continue
            kind = "file" if argument.name == PASSED_ON else kind_of(call)
            texts = texts_in(argument.value, apart=argument.name in LISTS or (not name and is_listed(argument.value)))
            yield from ((kind, as_command(text) if name == "Command" else text) for text in texts)
    yield from files_read(call)


def is_listed(value: Value) -> bool:
    """Return whether a list is one of several values: none goes on with the path of the first."""
    rest = value.items[1:] if isinstance(value, Sequence) else ()
    return not any(isinstance(each, Text) and each.text.startswith("/") and not each.is_path for each in rest)


def as_command(text: LaunchText) -> LaunchText:
    return LaunchText(text.span, (Substitution("command", (text,), text.span),))


def texts_in(value: Value, *, apart: bool = False, depth: int = 0) -> Iterator[LaunchText]:
    if depth > MAX_DEPTH:
        return
    match value:
        case Mapping():
            for _, item in value.items.values():
                yield from texts_in(item, depth=depth + 1)
        case Sequence() if apart:
            for item in value.items:
                yield from texts_in(item, depth=depth + 1)
        case Unknown():
            for option in value.options:
                yield from texts_in(option, apart=apart, depth=depth + 1)
        case _:
            yield text_of(value)


def writes(call: Call) -> bool:
    mode = call.get("mode", 1) if call.callee in READERS else None
    return isinstance(mode, Text) and not set(mode.text).isdisjoint("wax+")


def tested_paths(call: Call, folder: str) -> Iterator[FileReference]:
    """Yield the paths that a call tests for existence or creates."""
    if call.callee in PATH_TESTS or writes(call):
        for value in call.positional[:1]:
            yield from references_in(text_of(value), folder)
    elif call.receiver is not None and call.callee in PATH_METHODS:
        yield from references_in(text_of(call.receiver), folder)
