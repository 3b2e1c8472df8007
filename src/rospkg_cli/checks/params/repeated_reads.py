"""Parameters that are got twice, the second time in the place of one that is declared and never got."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.known_nodes import known_parameters
from ...source import Span
from .declaring_packages import is_its_own
from .forgotten_declarations import ForgottenDeclarations
from .forgotten_in_python import OF_LIBRARIES, counted
from .parameter_events import CPP_TEXT, Event, events_in_cpp, events_in_python
from .parameter_reads import allows_any

BY_OTHERS = regex(r"\bget_parameters\w*|\blist_parameters\b|PLUGINLIB_EXPORT_CLASS|ParametersClient")
"""Code that gets parameters by other means than one name each."""
BRACE = regex(r"[{}]")
DEF = regex(r"^\s*(?:async\s+)?(?:def|class)\s", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class RepeatedRead:
    path: str
    span: Span
    name: str
    """What is got again."""
    unread: str
    """What is declared in its place, and got by no code."""


@dataclass(frozen=True)
class RepeatedReads:
    forgotten: ForgottenDeclarations

    def all(self) -> Iterator[RepeatedRead]:
        """Yield the second read of a name that stands where another one, which no code gets, was declared."""
        reads, python = self.forgotten.reads, self.forgotten.python
        in_cpp = ((each.source, events_in_cpp(each)) for each in reads.cpp)
        in_python = ((each.source, events_in_python(each)) for each in python.modules)
        for source, found in (*in_cpp, *in_python):
            events = sorted(found, key=lambda each: each.span.start)
            if events and not allows_any(source) and not BY_OTHERS.search(source.text):
                for declared, read in in_place_of(source.text, events):
                    if self.is_unread(declared.name):
                        yield RepeatedRead(source.path, read.span, read.name, declared.name)

    def is_unread(self, name: str) -> bool:
        """Return whether a name stands once in all code, and no library may want it."""
        needed = self.forgotten.reads.package.dependencies
        is_theirs = any(known.fits(name) for each in needed for known in known_parameters(each.name))
        is_own = is_its_own(name) and not name.startswith(OF_LIBRARIES) and not is_theirs
        return is_own and self.texts.get(name) == 1

    @cached_property
    def texts(self) -> dict[str, int]:
        """How often each text stands in the code of both languages."""
        in_cpp = (
            found.group()[1:-1] for file in self.forgotten.reads.cpp for found in CPP_TEXT.finditer(file.source.text)
        )
        return counted([*in_cpp, *(text for text, times in self.forgotten.python.texts.items() for _ in range(times))])


def in_place_of(text: str, events: Sequence[Event]) -> Iterator[tuple[Event, Event]]:
    """Yield what is declared and what is got in its place: right behind it, or at its place in the row of reads.

    All of that is in one function, so that no other one asks for the same again.
    """
    if any(not each.name for each in events):
        return  # what it is called is only known at run time
    declared = [each for each in events if not each.is_read]
    read = [each for each in events if each.is_read]
    pairs = [(one, two) for one, two in pairwise(events) if not one.is_read and two.is_read]
    if len(declared) == len(read) and len({each.name for each in declared}) == len(declared):
        unlike = [pair for pair in zip(declared, read, strict=True) if pair[0].name != pair[1].name]
        pairs += unlike if len(unlike) == 1 else []
    for one, two in dict.fromkeys(pairs):
        same = [each for each in declared if each.name == two.name]
        earlier = [each for each in read if each.name == two.name and each.span.start < two.span.start]
        first = min((each.span.start for each in (*same, *earlier)), default=0)
        is_other = bool(two.target) and {"", two.target}.isdisjoint(each.target for each in earlier)
        is_row = len(same) == 1 and same[0].span.start < one.span.start < two.span.start
        if is_row and not one.target and earlier and is_other and is_one_function(text[first : two.span.start]):
            yield one, two


def is_one_function(between: str) -> bool:
    """Return whether nothing ends a function between two places, in either language."""
    depth = 0
    for each in BRACE.finditer(between):
        depth += 1 if each.group() == "{" else -1
        if depth < 0:
            return False
    return DEF.search(between) is None
