"""Make an index of names: rosdistro's files and rosdep's lists, read whole or not at all."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime, timezone

from ..ros.distros import DISTROS
from ..ros.name_index import Index, Named
from ..ros.rosdep import CODENAMES, apt_name, installer, merged, pip_names
from . import NamesError
from .fetch import NotThereError
from .file_url import FileUrl, shortened
from .rosdep_lists import RosdepList, rosdep_lists
from .rosdistro_files import Entries, distribution_files, document, is_name, released

Progress = Callable[[str, int, int], None]
"""Called with what is read next, how many files were read, and how many there are."""

Lists = Sequence[tuple[frozenset[str], Entries]]
"""The codenames for which a list holds, and what it holds."""


def make_index(
    place: FileUrl, distros: Iterable[str], environment: Mapping[str, str], progress: Progress = lambda *_: None
) -> Index:
    """Return the index of some distributions from the rosdistro at a place; raises NamesError.

    The environment may name folders with lists of rosdep's (ROSDEP_SOURCE_PATH).
    """
    wanted = [each.name for each in DISTROS if each.name in set(distros)]
    progress(str(place), 0, 1)
    files = wanted_files(place, wanted)
    lists = rosdep_lists(place, environment)
    places = [*(each for name in wanted for each in files[name]), *(each.place for each in lists)]

    def reading(each: FileUrl) -> FileUrl:
        progress(str(each), 1 + places.index(each), 1 + len(places))
        return each

    packages: dict[str, list[str]] = defaultdict(list)
    for distro in wanted:
        names = released([(each, document(reading(each))) for each in files[distro]])
        if not names:
            raise NamesError(f"{place} releases no package for {distro}; ask for what it has with --distro")
        for name in names:
            packages[name].append(distro)
    keys, pip, apt = tables([(each.codenames, entries_of(each, reading)) for each in lists])
    if not keys:
        raise NamesError(f"{place} has no rosdep key in its lists, and nor has this machine")
    return Index(
        str(shortened(place)),
        datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
        tuple(wanted),
        {name: tuple(which) for name, which in packages.items()},
        keys,
        pip,
        apt,
        tuple(str(each.place) for each in lists if each.elsewhere is None and not place.holds(each.place)),
    )


def wanted_files(place: FileUrl, wanted: Sequence[str]) -> dict[str, list[FileUrl]]:
    """Return the distribution files of some distributions; raises NamesError where there is none of one."""
    files = distribution_files(place, document(place))
    missing = [name for name in wanted if name not in files]
    if missing:
        there = ",".join(name for name in wanted if name in files)
        hint = f"ask for what it has: --distro {there}" if there else "it is of no use here"
        raise NamesError(f"{place} has no {' and no '.join(missing)}; {hint}")
    return files


def entries_of(listed: RosdepList, reading: Callable[[FileUrl], FileUrl]) -> Entries:
    """Return what a list holds; where the source lacks one of ros/rosdistro's, that one itself."""
    try:
        return document(reading(listed.place))
    except NotThereError:
        if listed.elsewhere is None:
            raise
        return document(listed.elsewhere)


def tables(lists: Lists) -> tuple[Named, Named, Named]:
    """Return the keys of some lists, and the names on PyPI and in Ubuntu that they stand for."""
    known = {key for _, entries in lists for key in entries if is_name(key)}
    ways: dict[str, list[str]] = {key: [] for key in known}
    pip: dict[str, set[str]] = defaultdict(set)
    apt: dict[str, set[str]] = defaultdict(set)
    for codename in CODENAMES.values():
        found = merged(entries for codenames, entries in lists if codename in codenames)
        for key in known:
            ways[key].append(installer(found.get(key), codename))
        for key in known & found.keys():
            entry = found[key]
            for name in pip_names(entry, codename):
                if is_name(name) and not called_alike(name, key):
                    pip[name].add(key)
            one = apt_name(entry, codename)
            if is_name(one) and one is not None and one not in known:
                apt[one].add(key)
    return {key: tuple(each) for key, each in ways.items()}, in_order(pip), in_order(apt)


def in_order(found: Mapping[str, set[str]]) -> Named:
    return {name: tuple(sorted(keys)) for name, keys in found.items()}


def called_alike(pip: str, key: str) -> bool:
    """Return whether a key is called like the name on PyPI, so that no finding is needed."""
    return key == f"python3-{pip.lower().replace('_', '-').replace('.', '-')}-pip"
