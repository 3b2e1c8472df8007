"""What is installed with the declared dependencies, and which of them brings it."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import EXPORTED, RUNS
from ...ros.read_table import rows

PASSED_ON = RUNS | EXPORTED
"""Tags whose packages are installed with the one that declares them; bloom makes the Depends of Debian of them."""

COLCON = "colcon"
WITH_COLCON = {"python3-pytest": COLCON}
"""What is installed wherever `colcon test` can run."""


def brought_by(first: Iterable[str], workspace: Workspace) -> Mapping[str, str]:
    """Return what comes with some packages: each name with the one of the first that brings it, by the shortest way.

    Packages of the workspace are known by their manifests, others by the tables; what neither knows brings nothing.
    """
    found: dict[str, str] = {}
    waiting = deque((name, name) for name in first)
    while waiting:
        name, bringer = waiting.popleft()
        for need in needs_of(name, workspace):
            if need not in found:
                found[need] = bringer
                waiting.append((need, bringer))
    return found


def brought_by_others(names: Iterable[str], workspace: Workspace) -> dict[str, str]:
    """Return those of some names that come with another one of them; of two that bring each other, the second."""
    found: dict[str, str] = {}
    left = sorted(names)
    for name in left:
        bringers = (other for other in left if other not in (name, *found) and name in brought_by([other], workspace))
        if (bringer := next(bringers, "")) and found.get(bringer) != name:
            found[name] = bringer
    return found


def needs_of(name: str, workspace: Workspace) -> Iterable[str]:
    """Return what a package passes on for certain."""
    facts = workspace.named(name)
    if facts is not None:
        return [need.name for need in facts.dependencies if need.certain and need.tag in PASSED_ON]
    return (*rows("runtime_dependencies.txt").get(name, ()), *rows("exported_dependencies.txt").get(name, ()))


def running(facts: PackageFacts) -> list[str]:
    """Return what a package declares for its run time, under conditions that hold for every target."""
    return [need.name for need in facts.dependencies if need.certain and need.tag in RUNS]


def everything(facts: PackageFacts) -> list[str]:
    """Return what a package declares for any time: all of it is there where it is built and tested."""
    return [need.name for need in facts.dependencies if need.certain and need.tag != "doc_depend"]
