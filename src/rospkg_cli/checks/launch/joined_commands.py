"""Programs that `Command` joins with what follows: it puts no blanks between the parts of its list (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, PartialText, Sequence, Text, Value
from ...lazy_regex import regex
from ...package.launch.launch_classes import is_substitution
from ..fault import Fault

PROGRAM = regex(r"[A-Za-z][\w.]*")


def joined_command(call: Call) -> Iterator[Fault]:
    """Yield a program that is followed by a file, or by what is known when the launch runs, without a blank."""
    command = call.get("command", 0)
    if not isinstance(command, Sequence) or len(command.items) < 2:
        return
    program, following = command.items[:2]
    if isinstance(program, Text) and PROGRAM.fullmatch(program.text) and is_file(following):
        joins = f"`Command` puts no blanks between its parts: `{program.text}` and the file become one word"
        yield Fault(
            command.places[0], f"{joins}, and the launch stops, as there is no such program; write `'{program.text} '`"
        )


def is_file(value: Value) -> bool:
    """Return whether a value certainly begins with the path of a file, or with what a substitution gives."""
    if isinstance(value, Text):
        return value.text.startswith("/")
    if isinstance(value, PartialText):
        first, *rest = value.parts
        below = isinstance(first, Call) and rest and isinstance(rest[0], Text) and rest[0].text.startswith("/")
        return value.is_path or is_substitution(first) or bool(below)
    return is_substitution(value)
