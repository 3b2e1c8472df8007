"""The lists of rosdep's keys: those of rosdistro, and those that a machine has in sources.list.d."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..ros.distros import DISTROS
from ..ros.rosdep import CODENAMES
from . import NamesError
from .fetch import NotThereError, fetch
from .file_url import FileUrl

MAX_LISTS = 100
"""ros/rosdistro has four; each of them is a file that is fetched."""

OWN = ("base.yaml", "python.yaml", "ruby.yaml")
DEFAULT_LISTS = "rosdep/sources.list.d/20-default.list"
OF_THE_MACHINE = "/etc/ros/rosdep/sources.list.d"

OFFICIAL = regex(r"/ros/rosdistro/[^/]+/(rosdep/[\w.-]+\.yaml)$")
"""A list of ros/rosdistro, on whatever host: the source has the same."""


@dataclass(frozen=True)
class RosdepList:
    """A list of keys; each of its tags (an operating system, a release of it, a distribution) limits it to that."""

    place: FileUrl
    tags: frozenset[str] = frozenset()
    elsewhere: FileUrl | None = None
    """Its own URL, for a source that does not have it."""

    @property
    def codenames(self) -> frozenset[str]:
        """The releases of Ubuntu for which it holds."""
        of_distros = {each.name: CODENAMES[each.ubuntu] for each in DISTROS}
        found = frozenset(CODENAMES.values())
        for tag in self.tags - {"ubuntu"}:
            found &= {of_distros.get(tag, tag)}
        return found


def rosdep_lists(source: FileUrl, environment: Mapping[str, str]) -> list[RosdepList]:
    """Return the lists in rosdep's order: the machine's, then those of the source that are not among them.

    Raises NamesError for a line that is none.
    """
    found = [each for path, text in texts(environment) for each in parsed(text, source, path)]
    try:
        own = list(parsed(fetch(source.join(DEFAULT_LISTS)).decode("utf-8", "replace"), source, DEFAULT_LISTS))
    except NotThereError:
        own = [RosdepList(source.join(f"rosdep/{name}")) for name in OWN]
    if len(found) + len(own) > MAX_LISTS:
        raise NamesError(f"{source} and this machine name {len(found) + len(own)} lists; at most {MAX_LISTS} are read")
    return [*found, *(each for each in own if each.place not in {other.place for other in found})]


def texts(environment: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Yield the files that rosdep reads on this machine, by path, with their texts."""
    folders = environment.get("ROSDEP_SOURCE_PATH", OF_THE_MACHINE).split(os.pathsep)
    for folder in filter(None, folders):
        for path in sorted(Path(folder).glob("*.list")):
            try:
                yield str(path), path.read_text("utf-8", "replace")
            except OSError as error:
                raise NamesError(f"`{path}` can't be read: {error.strerror or error}") from None


def parsed(text: str, source: FileUrl, path: str) -> Iterator[RosdepList]:
    for number, line in enumerate(text.splitlines(), 1):
        kind, *rest = line.split() or [""]
        if not kind or kind.startswith("#") or kind == "gbpdistro":
            continue
        if kind != "yaml" or not rest or not rest[0].startswith(("http://", "https://", "file:///")):
            raise NamesError(f"{path}:{number}: `{line.strip()}` is no source of rosdep: `yaml URL [TAG …]`")
        official = OFFICIAL.search(rest[0])
        place, tags = FileUrl(rest[0]), frozenset(rest[1:])
        yield RosdepList(source.join(official[1]), tags, place) if official else RosdepList(place, tags)
