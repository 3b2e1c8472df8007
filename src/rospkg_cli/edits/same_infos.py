"""One finding for what is the same in several files of a package and breaks nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ..finding import Fix, Hit, Related, Safety, Severity
from ..lazy_regex import regex

NAMED = regex(r"`[^`]*`|\(\d+ times[^)]*\)")
"""What differs between two places of one kind: the names, and how often there is one."""


def same_infos_once(hits: Iterable[Hit], title: str) -> Iterator[Hit]:
    """Yield hits, but of the infos of a kind only the first, with the others as related places and one fix for all."""
    kinds: dict[object, list[Hit]] = {}
    for hit in hits:
        kind = NAMED.sub("", hit.message).strip() if hit.level is Severity.INFO else hit
        kinds.setdefault(kind, []).append(hit)
    for first, *others in kinds.values():
        yield joined([first, *others], title) if others else first


def joined(hits: Sequence[Hit], title: str) -> Hit:
    first, *others = hits
    again = (place for each in others for place in (Related(each.path, each.span, "here too"), *each.related))
    fixes = [each.fix for each in hits if each.fix]
    safety = max((each.safety for each in fixes), key=[Safety.SAFE, Safety.UNSAFE].index, default=Safety.SAFE)
    operations = tuple(each for fix in fixes for each in fix.operations)
    fix = Fix(title, operations, safety) if len(fixes) == len(hits) else None
    return Hit(first.path, first.span, first.message, first.level, (*first.related, *again), fix)
