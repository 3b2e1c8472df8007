"""Dependency cycles: packages of a workspace that need each other for the order of colcon.

colcon-core orders packages by all their dependencies but doc_depend, test_depend included, and by those that these need
to run (colcon_core.topological_order, colcon_ros.package_identification.ros); REP-149 adds the members of groups. A
package that needs itself is no cycle here.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise

from ...light_dataclasses import dataclass
from ...package.package_facts import ActiveDependency, PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import NOT_ORDERED

Edges = Mapping[str, Mapping[str, ActiveDependency]]
"""By package, the packages that it depends on, each with the first such dependency."""


@dataclass(frozen=True)
class DependencyStep:
    package: PackageFacts
    needs: PackageFacts
    need: ActiveDependency


def dependency_cycles(workspace: Workspace) -> Iterator[tuple[DependencyStep, ...]]:
    """Yield one cycle for each strongly connected component: the shortest through its first selected package."""
    edges = needed(workspace)
    for knot in strongly_connected(edges):
        given = sorted(name for name in knot if named(workspace, name).folder in workspace.selected)
        if given:
            path = shortest(edges, given[0], knot)
            yield tuple(
                DependencyStep(named(workspace, here), named(workspace, there), edges[here][there])
                for here, there in pairwise(path)
            )


def named(workspace: Workspace, name: str) -> PackageFacts:
    found = workspace.named(name)
    assert found is not None
    return found


def needed(workspace: Workspace) -> Edges:
    """Return which package certainly needs which: the selected ones, and all that they need."""
    groups = GroupMembers(workspace)
    edges: dict[str, dict[str, ActiveDependency]] = {}
    waiting = [name for name in workspace.names if named(workspace, name).folder in workspace.selected]
    while waiting:
        name = waiting.pop()
        if name in edges:
            continue
        facts, found = named(workspace, name), edges.setdefault(name, {})
        for need in facts.dependencies:
            if need.certain and need.tag not in NOT_ORDERED and need.name in workspace.names:
                found.setdefault(need.name, need)
        for need in facts.group_dependencies:
            for member in groups.of.get(need.name, ()) if need.certain else ():
                found.setdefault(member, need)
        found.pop(name, None)
        waiting += found
    return {name: edges[name] for name in sorted(edges)}


@dataclass(frozen=True)
class GroupMembers:
    workspace: Workspace

    @cached_property
    def of(self) -> Mapping[str, Sequence[str]]:
        """The members of each group; all manifests are read for it, and few packages depend on a group."""
        found: dict[str, list[str]] = {}
        for facts in self.workspace.packages:
            for group in facts.groups:
                found.setdefault(group, []).append(facts.name)
        return found


def strongly_connected(edges: Edges) -> list[set[str]]:
    """Return the sets of two packages or more that reach each other (Tarjan's strongly connected components)."""
    order: dict[str, int] = {}
    low: dict[str, int] = {}
    open_: list[str] = []
    found: list[set[str]] = []
    for root in edges:
        if root in order:
            continue
        order[root] = low[root] = len(order)
        open_.append(root)
        work = [(root, iter(edges[root]))]
        while work:
            name, others = work[-1]
            other = next(others, None)
            if other is not None and other not in order:
                order[other] = low[other] = len(order)
                open_.append(other)
                work.append((other, iter(edges[other])))
            elif other is not None:
                low[name] = min(low[name], order[other]) if other in open_ else low[name]
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[name])
                if low[name] == order[name]:
                    at = open_.index(name)
                    found.append(set(open_[at:]))
                    del open_[at:]
    return [knot for knot in found if len(knot) > 1]


def shortest(edges: Edges, start: str, within: set[str]) -> list[str]:
    """Return the shortest way from a package back to itself, both ends included."""
    before: dict[str, str] = {}
    waiting = deque([start])
    while waiting:
        name = waiting.popleft()
        for other in edges[name]:
            if other == start:
                path = [start, name]
                while path[-1] != start:
                    path.append(before[path[-1]])
                return path[::-1]
            if other in within and other not in before:
                before[other] = name
                waiting.append(other)
    raise ValueError(f"{start} is in no cycle")
