"""What happens to launch configurations when a launch file runs, in the order of its visit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal as OneOf

from ...light_dataclasses import dataclass, replace
from ...source import Span
from .text import LaunchText, Literal

NOWHERE = Span(0, 0)

Kind = OneOf["use", "declare", "define", "pass", "include", "open", "push", "pop", "later"]
"""`pass`: an include sets it for the included file; `open`: anything may be set from here on; `push` and `pop`: a scope
of its own; `later`: what follows happens some time, when an event or a timer comes."""


@dataclass(frozen=True, slots=True)
class LaunchEvent:
    kind: Kind
    name: str = ""
    """Of the configuration; of the included file, without its folders; "" where it is unknown."""
    span: Span = NOWHERE
    is_optional: bool = False
    """Of a use: it has a default; of a declaration: it has none, so that the user has to set it."""
    passed_as: str = ""
    """Of a use: the argument of an include that is all that it becomes."""
    is_lookup: bool = False
    """Of a use: whether Python looks it up in a dict, and raises KeyError."""
    default: str | None = None
    """Of a use: what it is where nothing sets it; None where that is unknown, or it has none."""


def uses_of(*texts: LaunchText | None) -> Iterator[LaunchEvent]:
    """Yield the uses of launch configurations in some texts."""
    for text in texts:
        for found in text.substitutions("var") if text is not None else ():
            if found.arguments:
                name = found.arguments[0]
                span = name.span if name.literal else found.span
                default = found.arguments[1].literal if len(found.arguments) > 1 else None
                is_optional = len(found.arguments) > 1
                yield LaunchEvent("use", name.literal or "", span, is_optional=is_optional, default=default)


def passed_uses(uses: Iterable[LaunchEvent], name: str) -> Iterator[LaunchEvent]:
    """Yield the uses in what an include passes as an argument."""
    yield from (replace(event, passed_as=name) for event in uses)


def file_name(text: LaunchText) -> str:
    """Return the name of an included file, "" where its last parts are unknown."""
    tail = ""
    for part in reversed(text.parts):
        if not isinstance(part, Literal):
            return tail.rpartition("/")[2] if "/" in tail else ""
        tail = part.text + tail
    return tail.rpartition("/")[2]


@dataclass(frozen=True, slots=True)
class ConfigurationSummary:
    """What other launch files may know of one."""

    name: str
    """Of the file, without its folders."""
    defines: frozenset[str]
    """The launch configurations that it declares, sets, or passes on."""
    includes: frozenset[str]
    """The names of the files that it includes."""
    may_define_others: bool
    """Whether it may define others, or include others."""
    uses_undefined: bool = False
    """Whether it uses what it does not define itself: then another file sets it."""


def summary(name: str, events: Iterable[LaunchEvent], complete: bool) -> ConfigurationSummary:
    events = tuple(events)
    defined = [event for event in events if event.kind in ("declare", "define", "pass")]
    included = [event for event in events if event.kind == "include"]
    names = {event.name for event in defined}
    uses_undefined = any(e.kind == "use" and e.name and not e.is_optional and e.name not in names for e in events)
    unknown = any(not event.name for event in (*defined, *included)) or any(event.kind == "open" for event in events)
    return ConfigurationSummary(
        name,
        frozenset(event.name for event in defined if event.name),
        frozenset(event.name for event in included if event.name),
        unknown or not complete,
        uses_undefined,
    )
