"""What the declared dependencies of a package install with them: for a run, or for its build and tests."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cached_property

from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import DEPENDENCY_TAGS, RELATIONS, RUNS
from .brought_dependencies import (
    COLCON,
    WITH_COLCON,
    WITH_ROSDEP,
    Bringer,
    Brought,
    brought,
    brought_by_others,
    brought_by_sources,
)
from .intended_names import intended_names
from .misnamed_dependencies import MisnamedDependencies
from .transitive_dependencies import with_members


@dataclass(frozen=True)
class DependencyBringers:
    names: frozenset[str]
    """Every name that is declared."""
    misnamed: MisnamedDependencies
    facts: PackageFacts
    workspace: Workspace

    def bringer(self, names: Iterable[str], *, runs: bool) -> Bringer | None:
        """Return what brings one of some names for certain, else what may bring one; None where nothing does.

        With `runs`, it must be there when the package runs, else where the package is built and tested.
        """
        return self.bringer_among([*names], self.brought_to_run if runs else self.brought_to_build)

    def bringer_among(self, names: Sequence[str], there: Brought) -> Bringer | None:
        """Return what brings one of some names, among all that comes with some dependencies (`there`)."""
        if certain := next((there.certain[name] for name in names if name in there.certain), ""):
            return Bringer(certain)
        perhaps = next((found for name in names if (found := there.may_bring(name, self.workspace))), "")
        return Bringer(perhaps, is_certain=False) if perhaps else None

    def bringers(self, names: Iterable[str], *, runs: bool) -> Mapping[str, Bringer]:
        """Return what brings each of some missing packages, by name: a declared dependency, or another missing one.

        With `runs`, what dependencies for the build or tests certainly bring counts too: `rosdep install` installs it.
        """
        every = {name: found for name in names if (found := self.bringer([name], runs=runs))}
        sure = {name for name, found in every.items() if found.is_certain}
        built = {name: self.bringer([name], runs=False) for name in names if runs and name not in sure}
        every |= {name: found for name, found in built.items() if found and found.is_certain and found.name != COLCON}
        certain = {name: found for name, found in every.items() if found.is_certain}
        others = brought_by_others(set(names) - certain.keys(), self.workspace)
        return every | {name: Bringer(other) for name, other in others.items()} | certain

    @cached_property
    def brought_to_run(self) -> Brought:
        """What is there where the package runs."""
        return self.brought_with(RUNS)

    @cached_property
    def brought_to_build(self) -> Brought:
        """What is there where the package is built and tested; pytest is, because colcon needs it."""
        found = self.brought_with({*DEPENDENCY_TAGS}.difference(("doc_depend", *RELATIONS)))
        sources = brought_by_sources({**{name: name for name in self.names}, **found.certain}, self.workspace)
        return replace(found, certain={**sources, **found.certain, **WITH_COLCON})

    def brought_with(self, tags: Collection[str]) -> Brought:
        """Return what comes with the dependencies of some tags."""
        needs = [need for need in self.facts.dependencies if need.tag in tags]
        sure = (name for need in needs if need.certain for name in intended_names(need.name, self.workspace))
        certain = with_members([*sure, *self.misnamed.in_unknown_tags], self.workspace)
        found = brought(sorted(certain), sorted(need.name for need in needs if not need.certain), self.workspace)
        return replace(found, certain={**WITH_ROSDEP, **found.certain})
