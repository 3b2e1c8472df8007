"""Variables of C++ that hold a message, by their declarations."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .declared_names import end_of_scope, is_no_other

MESSAGE = r"(?<![\w:])(?:::)?([a-z]\w*)::(msg|srv|action)::([A-Z]\w*)(?:::(Request|Response|Goal|Result|Feedback))?"
END = r"(?=\s*[;=({,)]|\s+:[^:])"
BY_VALUE = regex(rf"{MESSAGE}(?:\s+const)?(?:\s+|\s*&{{1,2}}\s*)(?P<name>[A-Za-z_]\w*){END}")
BY_POINTER = regex(
    rf"{MESSAGE}::(?:Const)?(?:Shared|Unique)(?:Const)?Ptr(?:\s+const)?(?:\s+|\s*&{{1,2}}\s*)(?P<name>[A-Za-z_]\w*){END}"
)
IN_POINTER = regex(
    rf"(?:shared|unique)_ptr<\s*(?:const\s+)?{MESSAGE}(?:\s+const)?\s*>(?:\s+const)?(?:\s+|\s*&{{1,2}}\s*)"
    rf"(?P<name>[A-Za-z_]\w*){END}"
)
AUTO = r"auto(?<!\wauto)"
"""The word: what begins with a letter is looked for far quicker than what begins with a condition."""
MADE = regex(rf"{AUTO}\s+(?P<name>[A-Za-z_]\w*)\s*=\s*{MESSAGE}\s*[({{]")
MADE_POINTER = regex(
    rf"{AUTO}\s+(?P<name>[A-Za-z_]\w*)\s*=\s*std::make_(?:shared|unique)<\s*(?:const\s+)?{MESSAGE}\s*>\s*\("
)
FORMS = ((BY_VALUE, "."), (MADE, "."), (BY_POINTER, "->"), (IN_POINTER, "->"), (MADE_POINTER, "->"))
BOUND = regex(rf"{AUTO}\s*&{{0,2}}\s*\[([^\]]*)")
WORD = regex(r"\w+")


@dataclass(frozen=True, slots=True)
class MessageVariable:
    name: str
    message: str
    """`package/msg/Name`, `package/srv/Name_Request`."""
    access: str
    """How its fields are named: `.` or `->`."""
    start: int
    """From where to where it is known in the text."""
    end: int


def message_variables(text: str) -> Iterator[MessageVariable]:
    """Yield the variables of a code text that hold a message wherever the file declares their name.

    Where it is another message in another place, their scopes lie apart: the `msg` of two callbacks.
    """
    found: dict[str, list[tuple[int, str, str]]] = {}
    for pattern, access in FORMS:
        for match in pattern.finditer(text):
            package, kind, name, part = match.groups()[-4:] if match.re.groupindex["name"] == 1 else match.groups()[:4]
            message = f"{package}/{kind}/{name}{f'_{part}' if part else ''}"
            found.setdefault(match["name"], []).append((match.start("name"), message, access))
    bound = {word for match in BOUND.finditer(text) for word in WORD.findall(match[1])} if found else set()
    for name, places in found.items():
        if name in bound or not is_no_other(text, name, {at for at, _, _ in places}):
            continue
        ends = {at: end for at, _, _ in places if (end := end_of_scope(text, at)) > at}
        known = [MessageVariable(name, message, access, at, ends[at]) for at, message, access in places if at in ends]
        if are_apart(known):
            yield from known


def are_apart(variables: Sequence[MessageVariable]) -> bool:
    """Return whether no two variables of one name and of other messages are known at one place."""
    ordered = sorted(variables, key=lambda each: each.start)
    pairs = itertools.pairwise(ordered)
    return all((a.message, a.access) == (b.message, b.access) or a.end <= b.start for a, b in pairs)
