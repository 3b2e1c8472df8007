"""Variables of C++ that hold a message, by their declarations, and the members of it that code names."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence, Set

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span

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
NAMED = r"\s*([A-Za-z_]\w*)(?!\w|\s*::)"
"""A member by its name alone; `msg->my_msgs::msg::State::IDLE` names a class first, and then what it has."""
MEMBER = regex(rf"\s*\.{NAMED}")
USES = {".": MEMBER, "->": regex(rf"\s*->{NAMED}")}
"""What stands behind a variable whose member is named, by its access."""
CALL = regex(r"\s*\(")
BOUND = regex(rf"{AUTO}\s*&{{0,2}}\s*\[([^\]]*)")
WORD = regex(r"\w+")
DECLARED = regex(r"\s*[;=({,)\[:]")
SCOPE = regex(r"[(){};]")
NO_START = (".", ":", ">")
NO_TYPES = frozenset({"return", "else", "throw", "case", "delete", "co_return", "co_yield", "co_await"})


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


@dataclass(frozen=True, slots=True)
class MemberPath:
    """The members that code names of a variable, one of the other: `msg.header.stamp`."""

    variable: MessageVariable
    names: tuple[str, ...]
    spans: tuple[Span, ...]


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


def is_no_other(text: str, name: str, known: Set[int]) -> bool:
    """Return whether a text declares a name at no other places than these, but for structured bindings."""
    at = text.find(name)
    while at >= 0:
        end = at + len(name)
        if at not in known and has_type_before(text, at) and DECLARED.match(text, end):
            return False
        at = text.find(name, end)
    return True


def has_type_before(text: str, at: int) -> bool:
    """Return whether a name begins at an offset, and what stands before it is a type, not the end of an expression."""
    if is_of_word(text[at - 1 : at]) or text[at - 1 : at] == ".":
        return False
    end = at
    while text[end - 1 : end].isspace():
        end -= 1
    last = text[end - 1 : end]
    if not is_of_word(last):
        return last in ("&", "*") or (end < at and last in (">", "]"))
    start = end
    while is_of_word(text[start - 1 : start]):
        start -= 1
    return text[start:end] not in NO_TYPES


def is_of_word(char: str) -> bool:
    return char.isalnum() or char == "_"


def end_of_scope(text: str, at: int) -> int:
    """Return where the block ends that a declaration stands in; of a parameter, that of the function's body."""
    depth, inside = 0, 0
    for match in SCOPE.finditer(text, at):
        sign = match[0]
        if sign == "(":
            inside += 1
        elif sign == ")":
            inside -= 1
        elif sign == ";" and inside < 0 and depth == 0:
            return at  # a declaration of a function, which has no body
        elif sign == "{":
            depth += 1
        elif sign == "}":
            depth -= 1
            if depth < 0 or (depth == 0 and inside < 0):
                return match.end()
    return at


def member_paths(text: str, variable: MessageVariable) -> Iterator[MemberPath]:
    """Yield what a code text names of a variable; calls are left out, as messages have methods."""
    name, behind = variable.name, USES[variable.access]
    at = text.find(name, variable.start, variable.end)
    while at >= 0:
        end = at + len(name)
        before = text[at - 1 : at]
        found = None if is_of_word(before) or before in NO_START else behind.match(text, end, variable.end)
        if found is not None:
            end = found.end()
            yield from path_from(text, variable, found)
        at = text.find(name, end, variable.end)


def path_from(text: str, variable: MessageVariable, found: re.Match[str]) -> Iterator[MemberPath]:
    """Yield the members from the first one on that is found behind a variable."""
    names, spans, end = [found[1]], [Span(*found.span(1))], found.end()
    while (more := MEMBER.match(text, end)) is not None:
        names.append(more[1])
        spans.append(Span(*more.span(1)))
        end = more.end()
    keep = len(names) - (CALL.match(text, end) is not None)
    if keep:
        yield MemberPath(variable, tuple(names[:keep]), tuple(spans[:keep]))
