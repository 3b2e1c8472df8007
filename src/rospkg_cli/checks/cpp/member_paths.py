"""The members that C++ names of a variable that holds a message: `msg.header.stamp`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from .declared_names import is_of_word
from .message_variables import MessageVariable

NAMED = r"\s*([A-Za-z_]\w*)(?!\w|\s*::)"
"""A member by its name alone; `msg->my_msgs::msg::State::IDLE` names a class first, and then what it has."""
MEMBER = regex(rf"\s*\.{NAMED}")
USES = {".": MEMBER, "->": regex(rf"\s*->{NAMED}")}
"""What stands behind a variable whose member is named, by its access."""
CALL = regex(r"\s*\(")
NO_START = (".", ":", ">")


@dataclass(frozen=True, slots=True)
class MemberPath:
    """The members that code names of a variable, each one of the member before it."""

    variable: MessageVariable
    names: tuple[str, ...]
    spans: tuple[Span, ...]


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
