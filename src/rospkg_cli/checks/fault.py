"""What a check finds wrong in one file: the single type of every judgement that a rule passes on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

from ..light_dataclasses import dataclass, replace
from ..source import Span

Level = Literal["info", "warning", "error"]
WORST_FIRST: tuple[Level, ...] = ("error", "warning", "info")


@dataclass(frozen=True, slots=True)
class TextRepair:
    """Edits of the file that the fault is in: each replaces a span by a text; an empty span inserts."""

    title: str
    """In one line, as a fix is listed: "write `a`"."""
    edits: tuple[tuple[Span, str], ...]
    is_certain: bool = True
    """Nothing else can have been intended; otherwise the fix is unsafe."""


@dataclass(frozen=True, slots=True)
class Fault:
    span: Span
    message: str
    level: Level | None = None
    """None for the rule's own severity."""
    repair: TextRepair | None = None
    related: tuple[tuple[Span, str], ...] = ()
    """Other places in the same file, each with what it has to do with the fault."""


def replacement(span: Span, text: str, *, is_certain: bool = True) -> TextRepair:
    """Return the repair that replaces one span, titled by the text that it writes."""
    return TextRepair(f"write `{text}`", ((span, text),), is_certain)


def softer(fault: Fault, level: Level, when: str) -> Fault:
    """Return a fault that is one only under a condition."""
    return replace(fault, level=level, message=f"{fault.message}, {when}")


def softer_advice(fault: Fault, level: Level, when: str) -> Fault:
    """Return a fault that is one only under a condition, which is said before what to do: "…; write `a`"."""
    start, between, advice = fault.message.rpartition("; ")
    if not start or advice.count("`") % 2:
        return softer(fault, level, when)
    return replace(fault, level=level, message=f"{start}, {when}{between}{advice}")


def joined(faults: Sequence[Fault], message: str, title: str) -> Fault:
    """Return faults of one file that have one cause as one, at the first; it is repaired where all of them are."""
    first, *others = faults
    repairs = [each.repair for each in faults if each.repair]
    edits = tuple(edit for repair in repairs for edit in repair.edits)
    certain = all(repair.is_certain for repair in repairs)
    repair = TextRepair(title, edits, certain) if len(repairs) == len(faults) else None
    again = (place for each in others for place in ((each.span, "here too"), *each.related))
    related = tuple(dict.fromkeys((*first.related, *again)))
    return Fault(first.span, message, first.level, repair, related)


def once_each(faults: Iterable[Fault]) -> list[Fault]:
    """Return the faults of each kind as one: the same sentence, with the other places next to it."""
    found: dict[tuple[str, Level | None], dict[Span, Fault]] = {}
    for fault in faults:
        found.setdefault((fault.message, fault.level), {}).setdefault(fault.span, fault)
    groups = [list(each.values()) for each in found.values()]
    return [joined(same, same[0].message, same[0].repair.title if same[0].repair else "") for same in groups]
