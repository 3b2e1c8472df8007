"""Parameters that nodes of well-known packages do not declare, where these declare one of a similar name."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import replace
from ...ros.known_nodes import KnownParameter
from ...suggest import near_names, same_words
from .declaring_packages import ENOUGH
from .given_values import GivenValue
from .known_given import KnownNodes
from .known_group import KnownGroup
from .launched_names import SHORTEST, LaunchedName
from .unchanged_values import known_defaults, same_as_default

ENDINGS = frozenset({"_id", "_name", "_names", "_topic"})
"""What people leave away at the end of a name."""
SAME = frozenset({"_id", "_topic"})
"""What they put there; `camera_name` is not what `camera` is."""


def unknown_to_known(nodes: KnownNodes) -> Iterator[LaunchedName]:
    """Yield the names that a well-known package does not declare, where it declares one near name that is not given."""
    for group in nodes.groups():
        found = list(unknown_of(group))
        removed = [each for each in found if each.is_removed]
        yield from (each for each in found if not each.is_removed)
        if removed:
            yield replace(removed[0], others=tuple(each.span for each in removed[1:]))


def unknown_of(group: KnownGroup) -> Iterator[LaunchedName]:
    """Yield the names that none of the packages of a group declares."""
    unknown = [each for each in group.values if not any(may_fit(one, each.name) for one in group.declared)]
    is_owner = len(unknown) <= (1 - ENOUGH) * len(group.values) or len(group.values) == 1
    for each in unknown:
        is_removed = any(one.fits(each.name) for one in group.removed)
        near = list(intended_names(each, group)) if is_owner or is_removed or "/" in each.name else []
        if len(near) == 1:
            from .switched_off import why_off  # few packages need it

            names = each.name, near[0], is_removed, group.file, group.is_certain
            same = same_as_default(each.plain, near[0], known_defaults(group.packages, near[0]))
            same = same or why_off(group, near[0])
            yield LaunchedName(group.path, each.key, group.packages[0], *names, start=group.start, same=same)


def may_fit(known: KnownParameter, name: str) -> bool:
    """Return whether a name may be a parameter, perhaps behind a prefix, as code gives one to a parameter library."""
    return known.fits(name) or name.endswith(f".{known.name}")


def intended_names(value: GivenValue, group: KnownGroup) -> Iterator[str]:
    """Yield the names that a value may be for: those of a group are compared by their last pieces."""
    given = {each.name for each in group.values}
    before, dot, last = value.name.rpartition(".")
    ends = {one.name.lstrip(".") for one in group.declared if one.is_tail} if dot else set[str]()
    names = {one.name for one in group.declared if not one.is_tail} | {f"{before}.{end}" for end in ends}
    for name in sorted(names - given):
        end = name.removeprefix(f"{before}.") if dot else name
        if (
            f"/{name}" == value.name
            or name == value.name.replace("/", ".")
            or (len(last) >= SHORTEST and is_slip(last, end))
        ):
            yield name


def is_slip(word: str, right: str) -> bool:
    """Return whether one word of a name is misspelt, or the words are joined or in another order."""
    if word.replace("_", "").lower() == right.replace("_", "").lower() or same_words(word, [right]):
        return True
    pairs = [(a, b) for a, b in zip(word.split("_"), right.split("_"), strict=False) if a != b]
    if right.removeprefix(word) in ENDINGS or word.removeprefix(right) in SAME:
        return True
    is_one = len(word.split("_")) == len(right.split("_")) and len(pairs) == 1
    return is_one and min(map(len, pairs[0])) >= SHORTEST and bool(near_names(*pairs[0][:1], pairs[0][1:], 2))
