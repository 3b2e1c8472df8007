"""Variables of C++ that hold a message, by their declarations, and the members of it that code names."""

from __future__ import annotations

import re
from collections.abc import Iterator

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
MADE = regex(rf"\bauto\s+(?P<name>[A-Za-z_]\w*)\s*=\s*{MESSAGE}\s*[({{]")
MADE_POINTER = regex(
    rf"\bauto\s+(?P<name>[A-Za-z_]\w*)\s*=\s*std::make_(?:shared|unique)<\s*(?:const\s+)?{MESSAGE}\s*>\s*\("
)
FORMS = ((BY_VALUE, "."), (MADE, "."), (BY_POINTER, "->"), (IN_POINTER, "->"), (MADE_POINTER, "->"))
MEMBER = regex(r"\s*\.\s*([A-Za-z_]\w*)")
NO_TYPE = r"(?<!\breturn)(?<!\belse)(?<!\bthrow)(?<!\bcase)(?<!\bdelete)(?<!\bco_return)(?<!\bco_yield)(?<!\bco_await)"


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
    """Yield the variables of a code text that hold a message wherever the file declares their name."""
    found: dict[str, list[tuple[int, str, str]]] = {}
    for pattern, access in FORMS:
        for match in pattern.finditer(text):
            package, kind, name, part = match.groups()[-4:] if match.re.groupindex["name"] == 1 else match.groups()[:4]
            message = f"{package}/{kind}/{name}{f'_{part}' if part else ''}"
            found.setdefault(match["name"], []).append((match.start("name"), message, access))
    for name, places in found.items():
        if len({(message, access) for _, message, access in places}) == 1 and is_no_other(text, name, places):
            for at, message, access in places:
                if (end := end_of_scope(text, at)) > at:
                    yield MessageVariable(name, message, access, at, end)


def is_no_other(text: str, name: str, places: list[tuple[int, str, str]]) -> bool:
    """Return whether nothing else in a text may declare a name."""
    known = {at for at, _, _ in places}
    declared = re.compile(rf"{NO_TYPE}(?<=[\w>&*\]])\s*(?<![\w.])\b{name}\b(?=\s*[;=({{,)\[:])")
    bound = re.compile(rf"\bauto\s*&{{0,2}}\s*\[[^\]]*\b{name}\b")
    others = (match for match in declared.finditer(text) if text.rfind(name, match.start(), match.end()) not in known)
    return bound.search(text) is None and not any(is_declaration(text, match, name) for match in others)


def is_declaration(text: str, match: re.Match[str], name: str) -> bool:
    """Return whether what stands before a name is a type, not the end of an expression."""
    at = text.rfind(name, match.start(), match.end())
    before = text[:at].rstrip()
    return at != len(before) or before[-1:] in "&*"


def end_of_scope(text: str, at: int) -> int:
    """Return where the block ends that a declaration stands in; of a parameter, that of the function's body."""
    depth, inside = 0, 0
    for match in regex(r"[(){};]").finditer(text, at):
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
    use = re.compile(rf"(?<![\w.:>]){variable.name}\s*{re.escape(variable.access)}\s*([A-Za-z_]\w*)")
    for match in use.finditer(text, variable.start, variable.end):
        names, spans, end = [match[1]], [Span(*match.span(1))], match.end()
        while (more := MEMBER.match(text, end)) is not None:
            names.append(more[1])
            spans.append(Span(*more.span(1)))
            end = more.end()
        is_call = text[end:].lstrip()[:1] == "("
        if len(names) > is_call:
            keep = len(names) - is_call
            yield MemberPath(variable, tuple(names[:keep]), tuple(spans[:keep]))


KINDS_WITHIN = ("::msg::", "::srv::", "::action::")
BEHIND = regex(
    r"::(msg|srv|action)::([A-Z]\w*)(?:::(Request|Response|Goal|Result|Feedback))?(?:::\w+Ptr)?"
    r"(?:\s+const)?(?:\s*>)?(?:\s+const)?[\s&]*([A-Za-z_]\w*)?"
)
BEFORE = regex(r"auto\s+(\w+)\s*=\s*(?:std::make_\w+<\s*(?:const\s+)?)?(?:::)?\Z")
MOST_BEFORE = 120
"""Characters before a type that are looked at."""
CHAIN = regex(r"[A-Za-z_][\w.]*")


def named_members(text: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield messages with the members that a text may name of them: a quick look that finds more than there is."""
    found: dict[str, set[str]] = {}
    for name, message in named_variables(text):
        found.setdefault(name, set()).add(message)
    for name, message in ((name, *messages) for name, messages in found.items() if len(messages) == 1):
        for access in (".", "->"):
            start = name + access
            at = text.find(start)
            while at >= 0:
                chain = CHAIN.match(text, at + len(start))
                if chain is not None and not (text[at - 1].isalnum() or text[at - 1] == "_"):
                    names = tuple(filter(None, chain[0].split(".")))
                    yield message, names[:-1] if text.startswith("(", chain.end()) else names
                at = text.find(start, at + 1)


def named_variables(text: str) -> Iterator[tuple[str, str]]:
    """Yield what may be the name of a variable, with the message that stands beside it."""
    for within in KINDS_WITHIN:
        at = text.find(within)
        while at >= 0:
            start = at
            while start and (text[start - 1].isalnum() or text[start - 1] == "_"):
                start -= 1
            found = BEHIND.match(text, at)
            if found is not None and start < at:
                kind, base, part, name = found.groups()
                message = f"{text[start:at]}/{kind}/{base}{f'_{part}' if part else ''}"
                made = BEFORE.search(text[max(0, start - MOST_BEFORE) : start])
                yield from ((each, message) for each in (name, made[1] if made else None) if each)
            at = text.find(within, at + 1)
