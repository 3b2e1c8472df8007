"""What a name in package.xml is: a ROS package, a rosdep key, neither, or unknown."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from enum import Enum

from ..light_dataclasses import dataclass
from .distros import DISTROS, Distro, Targets
from .name_index import Index, parse
from .read_table import marked, rows
from .rosdep import CODENAMES, NOT_THERE


class NameKind(Enum):
    PACKAGE = "ROS package"
    KEY = "rosdep key"
    UNKNOWN = "unknown"
    CANT_TELL = "can't tell"


@dataclass(frozen=True)
class Names:
    """The names of released packages, and the keys of rosdep: those that are built in.

    Pickles small: the tables are read in the process that asks.
    """

    @property
    def packages(self) -> Mapping[str, Collection[str]]:
        """Package to the distributions that have it."""
        return marked("packages.txt")

    @property
    def keys(self) -> Mapping[str, Collection[str]]:
        """Key to its installer on each Ubuntu release of `CODENAMES`, `-` where there is none."""
        return marked("keys.txt")

    @property
    def pip(self) -> Mapping[str, tuple[str, ...]]:
        """Name on PyPI to the keys that install it, where these are not called like it."""
        return rows("pip.txt")

    @property
    def apt(self) -> Mapping[str, tuple[str, ...]]:
        """Ubuntu package to the keys that install it alone, where no key has its name."""
        return rows("apt.txt")

    @property
    def covered(self) -> Collection[str]:
        """The distributions of which a name that is not here does not exist."""
        return ()

    def kind_of(self, name: str, targets: Targets | None = None) -> NameKind:
        """Return what a name is for one of the targets; CANT_TELL for a package of another distribution alone."""
        distros = self.packages.get(name)
        wanted = DISTROS if targets is None else tuple(targets)
        if distros is not None and any(each.name in distros for each in wanted):
            return NameKind.PACKAGE
        if name in self.keys:
            return NameKind.KEY
        return NameKind.UNKNOWN if all(self.resolves(name, each) is False for each in wanted) else NameKind.CANT_TELL

    def resolves(self, name: str, distro: Distro) -> bool | None:
        """Return whether rosdep can install what a name stands for on a distribution; None where that is unknown."""
        if distro.name in self.packages.get(name, ()) or self.installer(name, distro) != NOT_THERE:
            return True
        return False if distro.name in self.covered else None

    def installer(self, key: str, distro: Distro) -> str:
        """Return the installer that serves a key on a distribution's Ubuntu, `-` where none does."""
        row = self.keys.get(key)
        if row is None:
            return NOT_THERE
        ways = dict(zip(CODENAMES, row, strict=False))
        return ways.get(distro.ubuntu, NOT_THERE)

    def is_package(self, name: str) -> bool:
        """Return whether a distribution that is supported has the package."""
        return name in self.packages

    def is_key(self, name: str) -> bool:
        return name in self.keys

    def is_pip(self, key: str, targets: Targets) -> bool:
        """Return whether PyPI serves a key on a target, as far as rosdep serves it at all."""
        return any(self.installer(key, each) == "pip" for each in targets)

    def all(self) -> Iterable[str]:
        """Return every name, of packages and of keys."""
        return (*self.packages, *self.keys)


BUILT_IN = Names()


@dataclass(frozen=True)
class FetchedNames(Names):
    """The names of an index that was fetched; for a distribution that is not in it, what is built in."""

    text: str
    """As `index.dump` writes it: read when the first name is asked for, in each process that asks."""

    @property
    def index(self) -> Index:
        return parse(self.text)

    @property
    def packages(self) -> Mapping[str, Collection[str]]:
        missing = {each.name for each in DISTROS}.difference(self.covered)
        if not missing:
            return self.index.packages
        found: dict[str, Collection[str]] = {
            name: kept for name, distros in BUILT_IN.packages.items() if (kept := missing.intersection(distros))
        }
        return found | {name: {*distros, *found.get(name, ())} for name, distros in self.index.packages.items()}

    @property
    def keys(self) -> Mapping[str, Collection[str]]:
        return self.index.keys

    @property
    def pip(self) -> Mapping[str, tuple[str, ...]]:
        return self.index.pip

    @property
    def apt(self) -> Mapping[str, tuple[str, ...]]:
        return self.index.apt

    @property
    def covered(self) -> Collection[str]:
        return self.index.distros

    def resolves(self, name: str, distro: Distro) -> bool | None:
        """As above; what is built in may contradict a no (a mirror may hold a part of rosdistro), never a yes."""
        found = super().resolves(name, distro)
        return None if found is False and BUILT_IN.resolves(name, distro) else found
