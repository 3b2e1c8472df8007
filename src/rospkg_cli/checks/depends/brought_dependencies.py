"""What is installed with the declared dependencies, and which of them brings it."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...ros.manifest import BUILDS
from .passed_on_dependencies import PassedOnIndex, is_in_table

COLCON = "colcon"
WITH_COLCON = {"python3-pytest": COLCON}
"""What is installed wherever `colcon test` can run."""
ROSDEP = "rosdep"
WITH_ROSDEP = dict.fromkeys((
    "python3-yaml", "python3-catkin-pkg", "python3-catkin-pkg-modules", "python3-rosdep", "python3-rosdep-modules",
    "python3-rosdistro-modules", "python3-rospkg", "python3-rospkg-modules",
), ROSDEP)  # fmt: skip
"""What is installed wherever `rosdep install` can run, which installs every other dependency."""


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
    """Packages among them whose own dependencies are unknown: anything may come with them."""
    unknown_keys: tuple[str, ...]
    """Keys of rosdep among them, whose dependencies are unknown as well: they bring no ROS package."""

    def may_bring(self, name: str, workspace: Workspace) -> str:
        """Return what may bring a package or a key; "" where it certainly does not come."""
        if name in self.perhaps:
            return self.perhaps[name]
        if self.unknown:
            return self.unknown[0]
        is_package = workspace.is_available(name) or workspace.index.is_package(name)
        alike = (key for key in self.unknown_keys if is_python(key) == is_python(name))
        return next(alike, "") if workspace.index.is_key(name) and not is_package else ""


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
    """Return the build dependencies of packages that are there and that can only be built from source.

    Each name comes with the bringer that `there` has for the package. A released package may be installed without what
    built it, so it counts for nothing.
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


def named_around(name: str, workspace: Workspace) -> Iterable[str]:
    """Return the dependencies of a package of the workspace."""
    facts = workspace.named(name)
    return (need.name for need in facts.dependencies) if facts is not None else ()


def is_key(name: str, workspace: Workspace, *, is_named: bool) -> bool:
    """Return whether a name is a key; what only the table names is a released package, or a key of some lists."""
    return workspace.index.is_key(name) or not (is_named or workspace.index.is_package(name))
