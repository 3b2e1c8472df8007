"""The text of a launch file that a plain `ros2 launch` reaches: without actions that are off by default."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...languages.python.unread_values import only_read_in
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import DeclaredArgument
from ...package.launch.live_text import without, without_unread
from ...package.launch.text import uncommented
from ...source import Span
from .action_conditions import TRUTHS, conditional
from .missing_reference import defaults_of
from .read_when_off import uses_of

GIVEN = (
    r"[\"']{0}[\"']\s*[,:]\s*(?:default(?:_value)?\s*=\s*)?[\"']?(\w+)|\b{0}:=[\"']?(\w+)"
    r"|\bname=[\"']{0}[\"']\s+(?:default|value)=[\"'](\w+)"
    r"|\bname:\s*[\"']?{0}[\"']?\s*(?:,\s*|\n\s+)(?:default|value):\s*[\"']?(\w+)"
)
"""How Python, a command, XML and YAML give an argument a literal value."""


def plain_texts(files: Sequence[LaunchFile], others: Iterable[tuple[str, str]]) -> Mapping[str, str]:
    """Return by path what some launch files say in what they do by default, where that is less than all.

    Args:
        others: path and text of what may turn something on, as it gives an argument another value.
    """
    found = {file.path: list(off_by_default(file)) for file in files}
    off = [file for file in files if found[file.path]]
    texts = list(others) if off else []
    alone = [file for file in off if not is_turned_on(file, (text for path, text in texts if path != file.path))]
    return {file.path: text_without(file, found[file.path]) for file in alone}


def off_by_default(file: LaunchFile) -> Iterator[Span]:
    """Yield the actions that are off by default, and values and defaults of arguments that they alone read."""
    own = [each.around for each in conditional(file) if each.holds is False]
    if not own:
        return
    if all(is_in(each.file.span, own) for each in file.includes):  # others may read an argument, too
        own += [span for each in file.arguments if is_read_in(file, each, own) for span in defaults_of([each])]
    yield from own
    yield from only_read_in(file.python, own) if file.python is not None else ()


def is_read_in(file: LaunchFile, argument: DeclaredArgument, spans: Sequence[Span]) -> bool:
    """Return whether only what stands in some places reads an argument."""
    uses = list(uses_of(file, argument.name.literal)) if argument.name.literal else []
    return bool(uses) and all(is_in(each, spans) for each in uses)


def is_turned_on(file: LaunchFile, texts: Iterable[str]) -> bool:
    """Return whether a text gives an argument of the file that is a truth by default the other value."""
    ways = []
    for each in file.arguments:
        is_on = TRUTHS.get((each.default.literal or "").lower()) if each.default is not None else None
        if is_on is not None and each.name.literal:
            ways.append((re.compile(GIVEN.format(re.escape(each.name.literal))), is_on))
    for text in texts if ways else ():
        for way, is_on in ways:
            given = (next(filter(None, each.groups()), "").lower() for each in way.finditer(text))
            if any(TRUTHS.get(value, is_on) is not is_on for value in given):
                return True
    return False


def text_without(file: LaunchFile, spans: Sequence[Span]) -> str:
    text = without_unread(file.python, spans) if file.python is not None else without(file.source.text, spans)
    return uncommented(file.path, text)


def is_in(place: Span, spans: Iterable[Span]) -> bool:
    return any(each.contains(place) for each in spans)
