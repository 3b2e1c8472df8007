"""Options that Python joins with the word before them, as no blank or comma parts two texts (LCH014)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, PartialText, Sequence, Text, Value
from ...lazy_regex import regex
from ...package.launch.launch_classes import class_of, span_within
from ...source import Source, Span
from ..fault import Fault, Level
from .program_prefixes import PROCESSES

JOINED = regex(r"(?P<before>[\w./-]*\w)(?P<option>--[a-z][a-z-]+)(?=[ =:]|$)")
TWO = regex(r"""(['"])([\w/.:=-]*\w)\1\s+(['"])([\w/.:=-]+)\3""")
"""Two literals that nothing parts."""
AN_OPTION = regex(r"--?[A-Za-z][\w-]*")
A_WORD = regex(r"[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*")
A_VALUE = regex(r"[\w/.].*")
A_LETTER = regex(r"-[A-Za-z]")
ITS_VALUE = regex(r"\w+|-?\d*\.\d+|\d+\.")
"""A number or a word, which argparse, getopt and Qt take in one word with an option of one letter."""
WHOLE_WORDS = frozenset({"create"})
"""Programs of gflags, for which `-z1.5` is a flag of that name: ros_gz_sim's."""
NEAR = 4
"""Letters on each side of a seam that stand together nowhere in the file."""
GAP = "\0"
"""Takes the place of a part that is not known."""
LISTS = ("cmd", "arguments", "ros_arguments", "command")


def joined_options(call: Call, source: Source) -> Iterator[Fault]:
    """Yield the texts of a command in which a literal begins with an option, but continues the word before it."""
    is_command = class_of(call) == "Command"
    if class_of(call) not in PROCESSES and not is_command:
        return
    for name in LISTS:
        words = call.get(name, 0 if name == "command" and is_command else None)
        items = zip(words.items, words.places, strict=True) if isinstance(words, Sequence) else ()
        for item, place in items if not is_command else ():
            if two := TWO.fullmatch(source.slice(place).strip()):
                yield from lost_comma(place, two[2], two[4]) if not is_taken(call, two[2], two[4]) else ()
            for found in seams(text_of(item), source.text):
                yield Fault(span_within(item, place), joins(found, " " in text_of(item)), level_of(name))
        if is_command and words is not None:
            whole = "".join(map(text_of, words.items)) if isinstance(words, Sequence) else text_of(words)
            for found in seams(whole, source.text):
                yield Fault(words.span, joins(found, True))


def is_taken(call: Call, first: str, second: str) -> bool:
    """Return whether a program takes an option of one letter and its value in one word."""
    program = call.get("executable")
    is_whole = isinstance(program, Text) and program.text in WHOLE_WORDS
    return bool(A_LETTER.fullmatch(first) and ITS_VALUE.fullmatch(second)) and not is_whole


def lost_comma(place: Span, first: str, second: str) -> Iterator[Fault]:
    """Yield two words of a list that Python makes one of, where one is an option, or both are plain words."""
    begins = AN_OPTION.fullmatch(first) and A_VALUE.fullmatch(second)
    ends = AN_OPTION.fullmatch(second) and not first.startswith("-")
    if begins or ends or (A_WORD.fullmatch(first) and A_WORD.fullmatch(second)):
        one = f"`{first}` and `{second}` become one word, `{first}{second}`, as no comma parts the two texts"
        yield Fault(place, f"{one}: the program stops or passes over it; put a comma before `{second}`", "warning")


def seams(text: str, source: str) -> Iterator[re.Match[str]]:
    for found in JOINED.finditer(text):
        at, option = found.start("option"), found["option"]
        is_written = text[max(0, at - NEAR) : at + NEAR] in source
        begins = any(f"{quote}{option}" in source for quote in ("'", '"'))
        if begins and not is_written:
            yield found


def joins(found: re.Match[str], is_line: bool) -> str:
    before, option = found["before"], found["option"]
    one = f"`{before}` and `{option}` become one word, `{before}{option}`, as nothing parts the two texts"
    better = f"a blank before `{option}`" if is_line else f"a comma before `{option}`"
    return f"{one}: the program stops or passes over it; put {better}"


def level_of(name: str) -> Level | None:
    """Return the level: the launch goes on without a process."""
    return "warning" if name != "command" else None


def text_of(value: Value) -> str:
    if isinstance(value, Text):
        return value.text
    return "".join(map(text_of, value.parts)) if isinstance(value, PartialText) else GAP
