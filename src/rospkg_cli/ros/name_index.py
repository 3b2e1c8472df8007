"""An index of names as one text: what is kept of rosdistro and of rosdep's lists, read back in a millisecond.

A line each, its kind first: `packages humble,jazzy NAME …` groups packages by the distributions that have them, `keys
apt,apt,- KEY …` keys by their installer on each Ubuntu release of `CODENAMES`.
"""

from __future__ import annotations

import zlib
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from ..light_dataclasses import dataclass, field

VERSION = 1
HEAD = f"rospkg-index {VERSION} "

Named = Mapping[str, tuple[str, ...]]


class BrokenIndexError(ValueError):
    """A text that is no index, or not the whole of one; the message says which."""


@dataclass(frozen=True)
class Index:
    source: str
    """Where it was fetched from."""
    fetched: str
    """When, as ISO 8601 has it, in UTC to the second."""
    distros: tuple[str, ...]
    """The distributions of which it knows every package."""
    packages: Named
    """Package to the distributions that have it."""
    keys: Named
    """Key to its installers."""
    pip: Named = field(default_factory=dict)
    """Name on PyPI to the keys that install it, where these are not called like it."""
    apt: Named = field(default_factory=dict)
    """Ubuntu package to the keys that install it alone, where no key has its name."""
    lists: tuple[str, ...] = ()
    """The local rosdep lists that were read in addition to those of the source."""

    def count(self, distro: str) -> int:
        """Return how many packages a distribution has."""
        return sum(distro in distros for distros in self.packages.values())


def dump(index: Index) -> str:
    """Return the text of an index, the same for the same index. Names with blanks are left out: none can be used."""
    lines = [f"source {one_line(index.source)}", f"fetched {index.fetched}", f"distros {' '.join(index.distros)}"]
    lines += [f"list {one_line(each)}" for each in index.lists]
    lines += [f"packages {','.join(mark)} {' '.join(names)}" for mark, names in grouped(index.packages)]
    lines += [f"keys {','.join(mark)} {' '.join(names)}" for mark, names in grouped(index.keys)]
    for kind, named in (("pip", index.pip), ("apt", index.apt)):
        lines += [f"{kind} {name} {' '.join(keys)}" for name, keys in sorted(named.items()) if is_word(name)]
    body = "\n".join([*lines, "end", ""])
    return f"{HEAD}{checksum(body)}\n{body}"


def grouped(named: Named) -> list[tuple[tuple[str, ...], list[str]]]:
    groups: dict[tuple[str, ...], list[str]] = defaultdict(list)
    for name, mark in sorted(named.items()):
        if is_word(name):
            groups[mark].append(name)
    return sorted(groups.items())


def is_word(name: str) -> bool:
    return name.split() == [name]


def one_line(text: str) -> str:
    return " ".join(text.split("\n"))


def checksum(body: str) -> str:
    return f"{zlib.crc32(body.encode()):08x}"


def check(text: str) -> None:
    """Raise BrokenIndexError where a text is not an index as it was written."""
    head, _, body = text.partition("\n")
    if head.startswith("rospkg-index ") and not head.startswith(HEAD):
        raise BrokenIndexError("it was written by another version of rospkg")
    if not head.startswith(HEAD):
        raise BrokenIndexError("it is no index of names")
    if head != HEAD + checksum(body):
        raise BrokenIndexError("it is broken or half of it is missing")


@lru_cache(4)
def parse(text: str) -> Index:
    """Return the index of a text that `check` has nothing against."""
    found: dict[str, dict[str, tuple[str, ...]]] = {kind: {} for kind in ("packages", "keys", "pip", "apt")}
    fields: dict[str, list[str]] = defaultdict(list)
    for kind, rest in kinds(text.split("\n")[1:]):
        if kind in ("packages", "keys"):
            mark, _, names = rest.partition(" ")
            found[kind] |= dict.fromkeys(names.split(), tuple(mark.split(",")))
        elif kind in found:
            name, *keys = rest.split()
            found[kind][name] = tuple(keys)
        else:
            fields[kind].append(rest)
    (source,), (fetched,), (distros,) = fields["source"], fields["fetched"], fields["distros"]
    return Index(source, fetched, tuple(distros.split()), **found, lists=tuple(fields["list"]))


def kinds(lines: Iterable[str]) -> Iterator[tuple[str, str]]:
    for line in lines:
        kind, _, rest = line.partition(" ")
        yield kind, rest
