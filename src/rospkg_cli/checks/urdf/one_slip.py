"""Faults of robots that are one slip, made several times: in one file, and in the files of a folder."""

from __future__ import annotations

from collections.abc import Iterable

from ...lazy_regex import regex
from ..enumeration import in_ticks
from ..fault import Fault, joined

WITHOUT_SIGN = regex(r"`([^`]*)` is read as it stands, for no `\$` is right before the brace: write `([^`]*)`(.*)")


def of_one_slip(faults: Iterable[Fault]) -> list[Fault]:
    """Return the faults with those as one that are expressions without their `$`, of one level."""
    groups: dict[object, list[Fault]] = {}
    for fault in faults:
        found = WITHOUT_SIGN.fullmatch(fault.message)
        groups.setdefault((found.group(3), fault.level) if found else id(fault), []).append(fault)
    return [same[0] if len(same) == 1 else joined(same, of_braces(same), "") for same in groups.values()]


def of_braces(faults: Iterable[Fault]) -> str:
    found = [match for fault in faults if (match := WITHOUT_SIGN.fullmatch(fault.message))]
    shown, right = (in_ticks(match.group(number) for match in found) for number in (1, 2))
    start = f"{shown} are read as they stand, for no `$` is right before their braces"
    return f"{start}: write {right}{found[0].group(3)}"


def is_slip(fault: Fault) -> bool:
    return "for no `$` is right before" in fault.message
