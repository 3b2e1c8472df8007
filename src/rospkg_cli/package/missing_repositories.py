"""Whether a repository that is listed and not checked out may hold a package, judging by the names of both."""

from __future__ import annotations

from collections.abc import Iterable

from ..lazy_regex import regex

WORD = regex(r"[a-z]+\d*")
COMMON = frozenset(
    "action actions api base bringup common control controller controllers core demo demos description descriptions "
    "driver drivers example examples gazebo gz interface interfaces lib library main manager message messages "
    "moveit msg msgs node nodes package packages plugin plugins py python robot robotics robots ros sdk sim simulation "
    "src srv srvs stack tool tools util utils vendor workspace".split()
)
"""Words that say nothing about what belongs together."""

MIN_LETTERS = 3
"""So many letters at the beginning of two words make them alike: `nav2` and `navigation`."""


def may_hold(repositories: Iterable[str], package: str) -> bool:
    """Return whether a package may be in one of some repositories: they share a word that is not in everybody's name.

    A name of common words alone (`robot_msgs`) may be anywhere.
    """
    wanted = telling_words(package)
    if not wanted:
        return True
    every = [each.rpartition("/")[2] for each in repositories]
    return any(are_alike(one, other) for each in every for one in telling_words(each) for other in wanted)


def is_called(repositories: Iterable[str], package: str) -> bool:
    """Return whether one of some repositories has the name of a package, which it then holds."""
    return any(spelt(each.rpartition("/")[2]) == spelt(package) for each in repositories)


def spelt(name: str) -> str:
    return name.lower().replace("-", "_")


def telling_words(name: str) -> set[str]:
    return {word for word in WORD.findall(name.lower()) if word.rstrip("0123456789") not in COMMON}


def are_alike(one: str, other: str) -> bool:
    """Return whether two words begin alike, or one holds the other."""
    short, long = sorted((one.rstrip("0123456789"), other.rstrip("0123456789")), key=len)
    return one == other or (len(short) >= MIN_LETTERS and (short in long or short[:MIN_LETTERS] == long[:MIN_LETTERS]))
