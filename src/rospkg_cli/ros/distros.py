"""The ROS 2 distributions that are supported, and what differs among them.

Sources: REP-2000 and the release pages of each distribution; versions of setuptools and CMake as Ubuntu ships them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache

from ..light_dataclasses import dataclass
from ..suggest import did_you_mean

Version = tuple[int, ...]


@dataclass(frozen=True)
class Distro:
    name: str
    title: str
    ubuntu: str
    python: Version
    setuptools: Version
    cmake: Version
    lts: bool
    end_of_life: str
    """Year and month; empty where there is none."""


DISTROS: tuple[Distro, ...] = (
    Distro("humble", "Humble Hawksbill", "22.04", (3, 10), (59, 6), (3, 22), True, "2027-05"),
    Distro("jazzy", "Jazzy Jalisco", "24.04", (3, 12), (68, 1), (3, 28), True, "2029-05"),
    Distro("kilted", "Kilted Kaiju", "24.04", (3, 12), (68, 1), (3, 28), False, "2026-12"),
    Distro("lyrical", "Lyrical Luth", "26.04", (3, 14), (78, 1), (4, 2), True, "2031-05"),
    Distro("rolling", "Rolling Ridley", "26.04", (3, 14), (78, 1), (4, 2), False, ""),
)

NEWEST_LTS = "lyrical"


def distro(name: str) -> Distro:
    """Return a distribution by its name; raises KeyError."""
    return {each.name: each for each in DISTROS}[name]


def fault_of_name(name: str) -> str:
    """Return what is wrong with a name that no distribution has, in a sentence; "" for one that is known."""
    names = [each.name for each in DISTROS]
    if name in names:
        return ""
    return f"there is no distribution `{name}`{did_you_mean(name, names)}; known: {', '.join(names)}"


@dataclass(frozen=True)
class Targets:
    """The distributions that a run checks for; `names` is empty where none was given."""

    names: tuple[str, ...] = ()

    def __iter__(self) -> Iterator[Distro]:
        """Yield the named distributions, or all of them where none is named."""
        return iter([each for each in DISTROS if each.name in self.names] or DISTROS)

    def named(self, holds: Callable[[Distro], bool]) -> bool:
        """Return whether it holds for a distribution that was given; if not, a problem has a lower level."""
        return any(holds(each) for each in self if each.name in self.names)

    def environments(self) -> Sequence[Mapping[str, str]]:
        """Return the variables in which REP-149 evaluates conditions, one for each target."""
        return environments_of(self)


@lru_cache(maxsize=64)
def environments_of(targets: Targets) -> Sequence[Mapping[str, str]]:
    """Return the variables for some targets; they are asked for at each dependency."""
    same = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "DISABLE_GROUPS_WORKAROUND": "1"}
    return tuple({**same, "ROS_DISTRO": each.name} for each in targets)
