"""What is installed with the declared dependencies, and which of them brings it."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from functools import cache

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...ros.manifest import BUILDS, EXPORTED, RUNS
from ...ros.read_table import rows

PASSED_ON = RUNS | EXPORTED
"""Tags whose packages are installed with the one that declares them; bloom makes the Depends of Debian of them."""

COLCON = "colcon"
WITH_COLCON = {"python3-pytest": COLCON}
"""What is installed wherever `colcon test` can run."""
ROSDEP = "rosdep"
WITH_ROSDEP = dict.fromkeys((
    "python3-yaml", "python3-catkin-pkg", "python3-catkin-pkg-modules", "python3-rosdep", "python3-rosdep-modules",
    "python3-rosdistro-modules", "python3-rospkg", "python3-rospkg-modules",
), ROSDEP)  # fmt: skip
"""What is installed wherever `rosdep install` can run, which every other dependency needs."""

RUNTIME, EXPORTS, DEBIAN = "runtime_dependencies.txt", "exported_dependencies.txt", "debian_dependencies.txt"
PERHAPS = "?"
"""Begins a name in the table that comes with a package on some distributions alone."""


@dataclass(frozen=True, slots=True)
class Bringer:
    """A dependency that brings another one: for certain, or perhaps."""

    name: str
    is_certain: bool = True


@dataclass(frozen=True, slots=True)
class Brought:
    """All that comes with some packages, each name with the one of them that brings it, and what is not known."""

    certain: Mapping[str, str]
    perhaps: Mapping[str, str]
    """What comes with them on some distributions, or under a condition."""
    unknown: tuple[str, ...]
    """Packages among them whose own dependencies no one here knows: anything may come with them."""
    unknown_keys: tuple[str, ...]
    """Keys of rosdep among them, likewise: a package of the system, or of PyPI, brings no package of ROS."""

    def may_bring(self, name: str, workspace: Workspace) -> str:
        """Return what may bring a package or a key; "" where it certainly does not come."""
        if name in self.perhaps:
            return self.perhaps[name]
        if self.unknown:
            return self.unknown[0]
        is_package = workspace.is_available(name) or workspace.index.is_package(name)
        alike = (key for key in self.unknown_keys if is_python(key) == is_python(name))
        return next(alike, "") if workspace.index.is_key(name) and not is_package else ""


@dataclass(frozen=True, slots=True)
class PassedOn:
    """What is installed with one package, for certain and perhaps, and whether that is known."""

    certain: tuple[str, ...]
    perhaps: tuple[str, ...]
    is_known: bool


def is_python(key: str) -> bool:
    return key.startswith("python")


def brought(first: Iterable[str], perhaps: Iterable[str], workspace: Workspace) -> Brought:
    """Return what comes with packages that are certainly there, and with others that are there under a condition."""
    first, perhaps = dict.fromkeys(first), list(perhaps)
    certain = brought_by(first, workspace)
    rest: dict[str, str] = {name: name for name in perhaps if name not in certain and name not in first}
    waiting = deque((*((name, certain.get(name, name)) for name in (*first, *certain)), *rest.items()))
    known = workspace.index_of(PassedOnIndex)
    while waiting:
        name, bringer = waiting.popleft()
        passed = known.get(name) or known.of(name, workspace)
        for need in (*passed.perhaps, *passed.certain) if name in rest else passed.perhaps:
            if need not in rest and need not in certain and need not in first:
                rest[need] = bringer
                waiting.append((need, bringer))
    every = dict.fromkeys((*first, *certain, *rest))
    unknown = [name for name in every if not known.of(name, workspace).is_known]
    if not unknown:
        return Brought(certain, rest, (), ())
    named = {*first, *perhaps, *(need for each in every for need in named_around(each, workspace))}
    keys = tuple(name for name in unknown if is_key(name, workspace, is_named=name in named))
    return Brought(certain, rest, tuple(name for name in unknown if name not in keys), keys)


def brought_by(first: Iterable[str], workspace: Workspace) -> Mapping[str, str]:
    """Return what comes with some packages: each name with the one of the first that brings it, by the shortest way.

    Packages of the workspace are known by their manifests, others by the tables; what neither knows brings nothing.
    """
    found: dict[str, str] = {}
    known = workspace.index_of(PassedOnIndex)
    waiting = deque((name, name) for name in first)
    while waiting:
        name, bringer = waiting.popleft()
        for need in (known.get(name) or known.of(name, workspace)).certain:
            if need not in found:
                found[need] = bringer
                waiting.append((need, bringer))
    return found


def brought_by_sources(there: Mapping[str, str], workspace: Workspace) -> dict[str, str]:
    """Return what the builds of packages need that are there, and are nowhere to be had but as sources.

    Each name comes with the one that `there` has as the bringer of the package. A package that is released may be
    installed without what built it.
    """
    found: dict[str, str] = {}
    for name, bringer in there.items():
        facts = None if is_in_table(name) else workspace.named(name)
        for need in facts.dependencies if facts is not None else ():
            if need.tag in BUILDS and need.certain and need.name not in there:
                found.setdefault(need.name, bringer)
    closure = brought_by(found, workspace)
    return {**{name: found[first] for name, first in closure.items() if first in found}, **found}


def brought_by_others(names: Iterable[str], workspace: Workspace) -> dict[str, str]:
    """Return those of some names that come with another one of them; of two that bring each other, the second."""
    found: dict[str, str] = {}
    left = sorted(names)
    comes_with = {other: brought_by([other], workspace) for other in left} if len(left) > 1 else {}
    for name in left:
        bringers = (other for other in left if other not in (name, *found) and name in comes_with[other])
        if (bringer := next(bringers, "")) and found.get(bringer) != name:
            found[name] = bringer
    return found


class PassedOnIndex(dict[str, PassedOn]):
    """What packages pass on, by name: the same closures are asked for by most packages of a workspace."""

    def of(self, name: str, workspace: Workspace) -> PassedOn:
        if name not in self:
            self[name] = found_passed_on(name, workspace)
        return self[name]


def found_passed_on(name: str, workspace: Workspace) -> PassedOn:
    facts = workspace.named(name)
    if facts is not None:
        needs = [need for need in facts.dependencies if need.tag in PASSED_ON]
        certain = (*(need.name for need in needs if need.certain), *sorted(facts.typed_with))
        return PassedOn(certain, tuple(need.name for need in needs if not need.certain), facts.knows("dependencies"))
    row = table_needs(name)
    perhaps = tuple(need[1:] for need in row if need[0] == PERHAPS)
    return PassedOn(tuple(need for need in row if need[0] != PERHAPS), perhaps, is_in_table(name))


def named_around(name: str, workspace: Workspace) -> Iterable[str]:
    """Return the dependencies of a package of the workspace."""
    facts = workspace.named(name)
    return (need.name for need in facts.dependencies) if facts is not None else ()


def is_key(name: str, workspace: Workspace, *, is_named: bool) -> bool:
    """Return whether a name is a key; what only the table names is a released package, or a key of some lists."""
    return workspace.index.is_key(name) or not (is_named or workspace.index.is_package(name))


@cache
def table_needs(name: str) -> tuple[str, ...]:
    """Return the row of the first table that knows a name."""
    return next((rows(table)[name] for table in (RUNTIME, EXPORTS, DEBIAN) if name in rows(table)), ())


def is_in_table(name: str) -> bool:
    return any(name in rows(table) for table in (RUNTIME, EXPORTS, DEBIAN))
