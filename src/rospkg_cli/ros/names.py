"""What a name in package.xml stands for: a ROS package, a rosdep key, neither, or nobody can tell."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum

from .distros import DISTROS, Targets
from .rosdep import CODENAMES
from .table import marked


class Known(Enum):
    PACKAGE = "ROS package"
    KEY = "rosdep key"
    UNKNOWN = "unknown"
    CANT_TELL = "can't tell"


@dataclass(frozen=True)
class Names:
    """The names of released packages, and the keys of rosdep; the built-in ones where nothing is given.

    Pickles small: the built-in tables are read in the process that asks.
    """

    released: Mapping[str, Collection[str]] | None = None
    """Package to the distributions that have it."""
    served: Mapping[str, Collection[str]] | None = None
    """Key to its installer on each Ubuntu release of `CODENAMES`, `-` where there is none."""
    own: frozenset[str] = field(default=frozenset())
    """Names that a user's own lists add: they are known, whatever they are."""
    complete: bool = False
    """Whether a name that is not here does not exist: so for an index that was fetched, not for what is built in."""

    @property
    def packages(self) -> Mapping[str, Collection[str]]:
        return marked("packages.txt") if self.released is None else self.released

    @property
    def keys(self) -> Mapping[str, Collection[str]]:
        return marked("keys.txt") if self.served is None else self.served

    def what(self, name: str, targets: Targets | None = None) -> Known:
        """Return what a name is for one of the targets; a package of another distribution can't be told."""
        distros = self.packages.get(name)
        if distros is not None and any(each.name in distros for each in targets or DISTROS):
            return Known.PACKAGE
        if name in self.keys or name in self.own:
            return Known.KEY
        return Known.UNKNOWN if self.complete else Known.CANT_TELL

    def is_package(self, name: str) -> bool:
        """Return whether a distribution that is supported has the package."""
        return name in self.packages

    def is_key(self, name: str) -> bool:
        return name in self.keys

    def is_pip(self, key: str, targets: Targets) -> bool:
        """Return whether PyPI serves a key on a target, as far as rosdep serves it at all."""
        releases = {each.ubuntu for each in targets}
        ways = zip(CODENAMES, self.keys.get(key, ()), strict=False)
        return any(release in releases and way == "pip" for release, way in ways)

    def all(self) -> Iterable[str]:
        """Return every name, of packages and of keys."""
        return (*self.packages, *self.keys)


BUILT_IN = Names()
