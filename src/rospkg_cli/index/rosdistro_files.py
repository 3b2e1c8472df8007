"""Read the files of rosdistro and the lists of rosdep: their shape is checked, everything else is left out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from . import NamesError
from .fetch import fetch
from .file_url import FileUrl

Entries = Mapping[Any, Any]

MAX_FILES = 50
"""Of one distribution; those of rosdistro have one each."""

LONGEST_NAME = 200


def document(place: FileUrl) -> Entries:
    """Return the mapping that a YAML file holds; raises NamesError, and NotThereError where there is no file."""
    from .plain_yaml import YamlError, plain_yaml  # 22 ms that no other command need pay

    try:
        loaded = plain_yaml(fetch(place))
    except YamlError as error:
        from_line = f", from line {error.line} on" if error.line else ""
        what = f"is not YAML{from_line}" if error.is_syntax else f"is not read{from_line}: {error}"
        raise NamesError(f"{place} {what}") from None
    if not isinstance(loaded, Mapping):
        raise NamesError(f"{place} is not what it should be: it holds no mapping; is that a page for people?")
    return loaded


def distribution_files(place: FileUrl, index: Entries) -> dict[str, list[FileUrl]]:
    """Return the distribution files of each distribution of an index file (REP-153); raises NamesError."""
    listed = index.get("distributions")
    if index.get("type") != "index" or not isinstance(listed, Mapping):
        raise NamesError(f"{place} is no index of rosdistro: it lists no distributions")
    found: dict[str, list[FileUrl]] = {}
    for name, entry in listed.items():
        files = entry.get("distribution") if isinstance(entry, Mapping) else None
        files = [files] if isinstance(files, str) else files
        if isinstance(files, list) and len(files) > MAX_FILES:
            raise NamesError(f"{place} names {len(files)} files for one distribution; at most {MAX_FILES} are read")
        if isinstance(name, str) and isinstance(files, list) and all(isinstance(each, str) for each in files):
            found[name] = [place.join(each) for each in files]
    return found


def released(files: Iterable[tuple[FileUrl, Entries]]) -> set[str]:
    """Return the packages that a distribution releases (REP-143); raises NamesError.

    Where a distribution has several files, a repository of a later one replaces that of an earlier one.
    """
    repositories: dict[Any, Any] = {}
    for place, entries in files:
        listed = entries.get("repositories")
        if entries.get("type") != "distribution" or not isinstance(listed, Mapping | None):
            raise NamesError(f"{place} is no distribution file of rosdistro")
        repositories |= listed or {}
    names: set[str] = set()
    for repository, entry in repositories.items():
        release = entry.get("release") if isinstance(entry, Mapping) else None
        if isinstance(release, Mapping) and release:
            listed = release.get("packages") or [repository]
            names |= {name for name in listed if is_name(name)} if isinstance(listed, list | Mapping) else set()
    return names


def is_name(name: object) -> bool:
    """Return whether something can be the name of a package or a key: a word that a terminal can show."""
    return isinstance(name, str) and len(name) <= LONGEST_NAME and name.isprintable() and name.split() == [name]
