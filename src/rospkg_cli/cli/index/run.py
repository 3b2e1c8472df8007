"""`rospkg index`: fetch the index of package names and rosdep keys, and show what it holds."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...config.file import user_config
from ...control_characters import visible
from ...index.cache import cache_file, cache_index, cached_index
from ...index.file_url import index_url
from ...index.update import make_index
from ...ros.distros import DISTROS, distro, fault_of_name
from ...ros.name_index import Index
from ...ros.names import BUILT_IN
from ...ros.rosdep import CODENAMES, NOT_THERE
from .. import UsageError
from ..progress import progress
from ..streams import afterwards
from .age import age, in_words


def update(source: str = "", distros: Sequence[str] = (), quiet: bool = False) -> int:
    """Fetch an index and replace the old one; return the exit status.

    Raises UsageError, ConfigError, and NamesError where the old one stays.
    """
    for name in distros:
        if fault := fault_of_name(name):
            raise UsageError(fault)
    own = user_config().index
    place = index_url(source, os.environ, own.get("source", ""))
    path = cache_file(os.environ)
    with progress(not quiet) as say:
        wanted = distros or own.get("distros") or [each.name for each in DISTROS]
        index = make_index(place, wanted, os.environ, lambda what, n, of: say(f"reading {n} of {of}: {what}"))
    cache_index(index, os.environ)
    if not quiet:
        afterwards(lambda: print("\n".join(shown(index, path))), "the index is written")
    return 0


def status(format: str = "text") -> int:
    """Print what was fetched, as text or as JSON; return the exit status. Raises NamesError for a broken index."""
    index = cached_index(os.environ)
    if format == "json":
        print(json.dumps(None if index is None else document(index, cache_file(os.environ)), indent=2))
    elif index is None:
        print(
            f"No index fetched; using {len(BUILT_IN.packages):,} built-in package names and {len(BUILT_IN.keys):,} "
            "rosdep keys. Other names can't be checked. `rospkg index update` fetches an index."
        )
    else:
        print("\n".join(shown(index, cache_file(os.environ))))
    return 0


def shown(index: Index, path: Path) -> Iterator[str]:
    """Yield the lines that describe an index."""
    yield f"source    {visible(index.source)}"
    yield from (f"list      {visible(each)}" for each in index.lists)
    yield f"fetched   {visible(index.fetched).replace('T', ' ').replace('Z', ' UTC')} ({in_words(age(index))})"
    yield f"kept in   {visible(str(path))}"
    for name in index.distros:
        keys = f"{keys_of(index, name):>5,} keys on Ubuntu {distro(name).ubuntu}"
        yield f"{name:<9} {index.count(name):>5,} packages, {keys}"


def keys_of(index: Index, name: str) -> int:
    """Return how many keys can be had on a distribution's Ubuntu."""
    at = list(CODENAMES).index(distro(name).ubuntu)
    return sum(ways[at] != NOT_THERE for ways in index.keys.values())


def document(index: Index, path: Path) -> dict[str, object]:
    counts = {name: {"packages": index.count(name), "keys": keys_of(index, name)} for name in index.distros}
    return {
        "source": index.source,
        "lists": list(index.lists),
        "fetched": index.fetched,
        "age_days": age(index),
        "path": str(path),
        "distros": counts,
    }
