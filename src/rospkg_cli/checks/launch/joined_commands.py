"""Words that launch joins without blanks: the parts of `Command`, of a prefix, and of a list inside a list (LCH014)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, PartialText, Sequence, Text, Unknown, Value
from ...lazy_regex import regex
from ...package.launch.launch_classes import is_substitution
from ..fault import Fault

PROGRAM = regex(r"[A-Za-z][\w.]*")
OPTION = regex(r"--[a-z][\w-]*")
WORD = regex(r"-|[A-Za-z0-9]")
MAPPING = regex(r"[A-Za-z_]\w*:=")
WORD_END = regex(r"[\w./]$")
LISTS = ("cmd", "arguments", "ros_arguments")


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


def joined_mapping(call: Call) -> Iterator[Fault]:
    """Yield a `name:=value` that a `Command` hands to xacro, and that no blank parts from what stands before it."""
    command = call.get("command", 0)
    if not isinstance(command, Sequence) or not command.is_display or not mentions(command, "xacro"):
        return
    earlier = (None, *command.items)
    for index, (first, before, each) in enumerate(zip(earlier, command.items, command.items[1:], strict=False), 1):
        found = MAPPING.match(each.text) if isinstance(each, Text) else None
        end = before.parts[-1] if isinstance(before, PartialText) else before
        is_word = isinstance(end, Text) and WORD_END.search(end.text)
        may_be_empty = isinstance(first, Text) and first.text.endswith(" ")
        if found and (is_word or (is_substitution(before) and not may_be_empty)):
            joins = f"`Command` puts no blanks between its parts: `{found[0]}` is joined with what stands before it"
            yield Fault(command.places[index], f"{joins}, and xacro stops; write `' {found[0]}'`")


def mentions(value: object, word: str) -> bool:
    match value:
        case Text(text=text):
            return word in text
        case Sequence(items=items):
            return any(mentions(each, word) for each in items)
        case Call(arguments=arguments):
            return any(mentions(each.value, word) for each in arguments)
    return False


def joined_words(call: Call) -> Iterator[Fault]:
    """Yield the first word of a prefix, and of a list inside the words of a process, that the next one continues."""
    given = call.get("prefix")
    for prefix in given.options if isinstance(given, Unknown) else (given,):
        if isinstance(prefix, Sequence) and (word := continued(prefix, PROGRAM)):
            message = f"`prefix` puts no blanks between its parts: {stops(word)}"
            yield Fault(prefix.places[0], message, "warning" if isinstance(given, Unknown) else None)
    for name in LISTS:
        words = call.get(name)
        for index, inner in enumerate(words.items) if isinstance(words, Sequence) else ():
            is_program = name == "cmd" and index == 0
            if isinstance(inner, Sequence) and (word := continued(inner, PROGRAM if is_program else OPTION)):
                start = f"a list inside `{name}` is one word, without blanks between its parts"
                what = stops(word) if is_program else f"`{word}` is joined with what follows, and is no option then"
                message = f"{start}: {what}; put each word into `{name}` itself"
                yield Fault(inner.places[0], message, None if is_program else "warning")


def continued(words: Sequence, pattern: re.Pattern[str]) -> str:
    """Return the first of several words, where a second one begins with no blank; "" for anything else."""
    first, second = (*words.items, None, None)[:2]
    if not isinstance(first, Text) or not pattern.fullmatch(first.text) or first.is_path:
        return ""
    is_word = isinstance(second, Text) and WORD.match(second.text)
    return first.text if is_word or (pattern is OPTION and second is not None and is_substitution(second)) else ""


def stops(word: str) -> str:
    return f"`{word}` and the next become one word, and the launch stops, as there is no such program"


def is_file(value: Value) -> bool:
    """Return whether a value certainly begins with the path of a file, or with what a substitution gives."""
    if isinstance(value, Text):
        return value.text.startswith("/")
    if isinstance(value, PartialText):
        first, *rest = value.parts
        below = isinstance(first, Call) and rest and isinstance(rest[0], Text) and rest[0].text.startswith("/")
        return value.is_path or is_substitution(first) or bool(below)
    return is_substitution(value)
