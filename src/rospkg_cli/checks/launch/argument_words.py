"""The words that a node gets on its command line, as far as a launch file shows them."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Constant, Sequence, Value
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import LaunchText, Literal
from ...source import Span

QUOTES = ('"', "'", "\\")
ROS_ARGUMENTS = "--ros-args"


@dataclass(frozen=True, slots=True)
class ArgumentWord:
    text: str | None
    """None where a part of it is known at run time only."""
    span: Span


def words_of(file: LaunchFile, node: LaunchedNode) -> list[ArgumentWord] | None:
    """Return the words in their order without those for ROS; None where there may be others."""
    if not node.is_complete or node.kind != "node":
        return None
    found = words_of_python(file, node) if file.evaluated else words_of_entity(file, node)
    return None if found is None else list(without_ros(found))


def words_of_python(file: LaunchFile, node: LaunchedNode) -> list[ArgumentWord] | None:
    calls = [call for call in file.evaluated.calls if call.span == node.span] if file.evaluated else []
    made = [each for each in file.nodes if each.span == node.span]  # several where a function makes them
    if len(calls) != len(made):
        return None
    call = next(call for call, each in zip(calls, made, strict=True) if each is node)
    given, for_ros = call.get("arguments"), call.get("ros_arguments")
    if for_ros is not None or not (given is None or is_known_list(given)):
        return None
    return [ArgumentWord(each.literal, each.span) for each in node.arguments]


def is_known_list(value: Value) -> bool:
    """Return whether a value is a list of which each item is one word."""
    is_list = isinstance(value, Sequence) and value.kind != "set" and value.is_complete and not value.open_conditions
    return is_list and not any(isinstance(each, Constant | Sequence) for each in getattr(value, "items", ()))


def words_of_entity(file: LaunchFile, node: LaunchedNode) -> list[ArgumentWord] | None:
    """Return the words of `args`, which launch splits before it replaces what stands in them."""
    if "ros_args" in file.source.text or any('"' in (each.literal or "") for each in node.arguments):
        return None
    found: list[ArgumentWord] = []
    for text in node.arguments:
        if text.unknown or any(isinstance(p, Literal) and any(q in p.text for q in QUOTES) for p in text.parts):
            return None
        found += split(text)
    return found


def split(text: LaunchText) -> Iterator[ArgumentWord]:
    """Split a text at its blanks; what is replaced is not split."""
    piece, is_open = "", False
    is_known = True
    for part in text.parts:
        if not isinstance(part, Literal):
            is_open, is_known = True, False
            continue
        for letter in part.text:
            if not letter.isspace():
                piece, is_open = piece + letter, True
            elif is_open:
                yield ArgumentWord(piece if is_known else None, text.span)
                piece, is_open, is_known = "", False, True
    if is_open:
        yield ArgumentWord(piece if is_known else None, text.span)


def without_ros(words: list[ArgumentWord]) -> Iterator[ArgumentWord]:
    """Leave out what stands between `--ros-args` and `--`."""
    is_for_ros = False
    for word in words:
        if word.text == ROS_ARGUMENTS:
            is_for_ros = True
        elif is_for_ros and word.text == "--":
            is_for_ros = False
        elif not is_for_ros:
            yield word
