"""Whether what a launch file makes and never adds is started by another action, of it or of a file next to it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.python.evaluate.values import Call, Sequence
from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.never_launched import never_launched
from ...package.launch.python_to_text import text_of
from ...source import Span

STRING = regex(r"([\"'])([\w./-]+)\1")


def started_elsewhere(call: Call, file: LaunchFile, around: Iterable[LaunchFile]) -> str:
    """Return the launch file that starts the same program by an action that is added; "" for none."""
    for other in (file, *(each for each in around if each.path != file.path)):
        if not other.is_ros1 and (starts_same(call, file, other) or names_last_word(call, file, other)):
            return other.path
    return ""


def starts_same(call: Call, file: LaunchFile, other: LaunchFile) -> bool:
    """Return whether a node that is added has the package, the executable, the name and the arguments of a call."""
    mine = next((node for node in file.nodes if node.span == call.span), None)
    program = key_of(mine) if mine is not None else None
    if mine is None or program is None:
        return False
    return any(key_of(node) == program and not are_apart(mine, node) for node in added(other))


def added(file: LaunchFile) -> Iterator[LaunchedNode]:
    lost = never_launched(file.python) if file.python is not None else ()
    return (node for node in file.nodes if not any(span.contains(node.span) for span in lost))


def key_of(node: LaunchedNode) -> tuple[str, str] | None:
    package, executable = (text.literal if text else None for text in (node.package, node.executable))
    return (package, executable) if package and executable else None


def are_apart(one: LaunchedNode, other: LaunchedNode) -> bool:
    """Return whether two nodes of one program certainly differ, by their names or by their arguments."""
    names = [node.name.literal for node in (one, other) if node.name is not None and node.name.literal]
    words = [[text.literal for text in node.arguments] for node in (one, other)]
    return len({*names}) > 1 or (words[0] != words[1] and not any(None in each for each in words))


def names_last_word(call: Call, file: LaunchFile, other: LaunchFile) -> bool:
    """Return whether an action that is added has the last word of a command: `ros2 control … arm_controller`."""
    words = call.get("cmd")
    last = text_of(words.items[-1]).literal if isinstance(words, Sequence) and words.items else None
    if other is not file or not last or file.python is None:
        return False
    lost = never_launched(file.python)
    spans = (Span(*match.span()) for match in STRING.finditer(file.source.text) if match.group(2) == last)
    return any(not any(each.contains(span) for each in lost) for span in spans)
