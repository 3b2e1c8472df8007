"""What package.xml declares: whether a package that is used is declared, directly or through others."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.aliases import key_for_pip, successors
from ...ros.distros import Targets
from ...ros.manifest import BUILD_TYPES, CONDITIONAL_TAGS, DEPENDENCY_TAGS, EXPORTED, RELATIONS, RUNS
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...suggest import near_names
from ..repository.older_distribution import OlderDistribution
from ..repository.released import Release
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
from .declared_beside import brought_in, is_declared_by_others
from .intended_names import intended_names, key_of_cmake_name
from .system_installs import SystemInstalls

if TYPE_CHECKING:
    from .hidden_packages import HiddenPackages

MAX_DEPTH = 20


def normalized(name: str) -> str:
    return name.replace("-", "_").lower()


COMMENTED_DEPENDENCY = regex(r"(?:<|^\s*)\w*depend\b[^>]*>\s*([\w.-]+)\s*<", re.MULTILINE)
"""A tag in a comment, or one that is made a comment by its own brackets: `<!-- depend>a</depend -->`."""


@dataclass(frozen=True)
class DeclaredDependencies:
    """The dependencies of one package, with the members of the metapackages that it declares."""

    manifest: Manifest
    facts: PackageFacts
    workspace: Workspace
    release: Release

    @property
    def is_checked(self) -> bool:
        """Whether this is a package of ROS 2 of a build type that rospkg reads."""
        return self.facts.build_type in BUILD_TYPES and self.facts.build_type != "catkin"

    @cached_property
    def names(self) -> frozenset[str]:
        """Every name that is declared, under any tag and any condition that holds for a distribution of ROS 2."""
        return frozenset(self.closure(d.name for d in self.manifest.dependencies if d.active(Targets())))

    def closure(self, names: Iterable[str]) -> set[str]:
        """Return some names, and the members of the metapackages among them."""
        found: set[str] = set()
        waiting = [(name, 0) for name in names]
        while waiting:
            name, depth = waiting.pop()
            if name in found:
                continue
            found.add(name)
            facts = self.workspace.named(name)
            if depth < MAX_DEPTH:
                waiting += [(other, depth + 1) for other in metapackage_members(name, facts)]
        return found

    def has(self, names: Iterable[str]) -> bool:
        """Return whether one of some names is declared, or is the package itself, or can't be declared."""
        return any(map(self.has_name, names))

    def has_to_run(self, name: str) -> bool:
        """Return whether a package is declared, or is one here that is found under that name, which is not its own."""
        return self.has_name(name) or self.workspace.is_marked(name)

    def has_name(self, name: str) -> bool:
        if name not in self._had:
            is_own = name in self.names or name == self.facts.name
            self._had[name] = is_own or self.is_needed_by(name) or self.is_reported_elsewhere(name)
        return self._had[name]

    @cached_property
    def _had(self) -> dict[str, bool]:
        """What `has` said of each name: rules ask for some hundreds again and again."""
        return {}

    def is_reported_elsewhere(self, name: str) -> bool:
        """Return whether package.xml names it wrongly, which another rule reports.

        It is the package itself in another spelling or by the name of its own module, a dependency in an unknown tag,
        one of several in one tag, what took the place of a ROS 1 package, or one with an unknown name that is similar,
        or that is the name on PyPI.
        """
        if normalized(name) == normalized(self.facts.name) or name in self.in_unknown_tags or self.is_own_folder(name):
            return True
        if name in self.own_modules and self.workspace.named(name) is None:
            return True
        return name in self.written_otherwise or bool(self.unknown_names and near_names(name, self.unknown_names))

    def is_own_folder(self, name: str) -> bool:
        """Return whether the package lies in a folder of a name that its own name is a slip of."""
        is_folder = name == self.facts.folder.rpartition("/")[2] and self.workspace.named(name) is None
        return is_folder and bool(near_names(self.facts.name, [name]))

    @cached_property
    def own_modules(self) -> frozenset[str]:
        return frozenset(module.partition(".")[0] for module in self.facts.modules)

    @cached_property
    def in_unknown_tags(self) -> frozenset[str]:
        """What stands in tags that are near to one of dependencies; a group is no package."""
        unknown = (each for each in self.manifest.root.children if each.tag not in CONDITIONAL_TAGS)
        return frozenset(e.text for e in unknown if "depend" in e.tag.lower() or near_names(e.tag, DEPENDENCY_TAGS))

    @cached_property
    def unknown_names(self) -> frozenset[str]:
        """The declared names that are no package and no key; what counts for ROS 1 alone is reported by no rule."""
        known = (NameKind.PACKAGE, NameKind.KEY)
        active = (d for d in self.manifest.dependencies if d.active(Targets()))
        return frozenset(d.name for d in active if self.workspace.kind_of(d.name) not in known)

    @cached_property
    def written_otherwise(self) -> frozenset[str]:
        """What declared names stand for that are names on PyPI, of CMake or in ROS 1, or several in one tag."""
        keys = (key for name in self.unknown_names if (key := key_of_cmake_name(name) or key_for_pip(name)) is not None)
        parts = (words for name in self.unknown_names if len(words := name.replace(",", " ").split()) > 1)
        active = (d.name for d in self.manifest.dependencies if d.active(Targets()))
        old = (successors(name) or () for name in active if self.workspace.named(name) is None)
        return frozenset([*keys, *(each for words in (*parts, *old) for each in words)])

    def bringer(self, names: Iterable[str], *, runs: bool) -> Bringer | None:
        """Return what brings one of some names for certain, else what may bring it; None where nothing does.

        With `runs`, it is there when the package runs; else where the package is built and tested.
        """
        return self.bringer_among([*names], self.brought_to_run if runs else self.brought_to_build)

    def bringer_among(self, names: Sequence[str], there: Brought) -> Bringer | None:
        """Return what brings one of some names, of all that comes with some dependencies."""
        if certain := next((there.certain[name] for name in names if name in there.certain), ""):
            return Bringer(certain)
        perhaps = next((found for name in names if (found := there.may_bring(name, self.workspace))), "")
        return Bringer(perhaps, is_certain=False) if perhaps else None

    def bringers(self, names: Iterable[str], *, runs: bool) -> Mapping[str, Bringer]:
        """Return what brings each of some missing packages: a declared dependency, or another one of them.

        What those for the build or tests bring for certain is there too: `rosdep install` installs it.
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
        return self.brought_with(RUNS)

    @cached_property
    def brought_to_build(self) -> Brought:
        """What is there where the package is built and tested, pytest included, which colcon needs itself."""
        found = self.brought_with({*DEPENDENCY_TAGS}.difference(("doc_depend", *RELATIONS)))
        sources = brought_by_sources({**{name: name for name in self.names}, **found.certain}, self.workspace)
        return replace(found, certain={**sources, **found.certain, **WITH_COLCON})

    def brought_with(self, tags: Collection[str]) -> Brought:
        """Return what comes with the dependencies of some tags."""
        needs = [need for need in self.facts.dependencies if need.tag in tags]
        sure = (name for need in needs if need.certain for name in intended_names(need.name, self.workspace))
        certain = self.closure([*sure, *self.in_unknown_tags])
        found = brought(sorted(certain), sorted(need.name for need in needs if not need.certain), self.workspace)
        return replace(found, certain={**WITH_ROSDEP, **found.certain})

    def transitive_names_of(self, names: Iterable[str]) -> tuple[frozenset[str], bool]:
        """Return the exported dependencies of some packages, and whether they are known of all of them."""
        found: set[str] = set()
        known, table = True, rows("exported_dependencies.txt")
        waiting = list(names)
        while waiting:
            name = waiting.pop()
            facts = self.workspace.named(name)
            if facts is not None:
                needs = [need.name for need in facts.dependencies if need.tag in EXPORTED]
            else:
                needs = list(table.get(name, ()))
                known &= name in table or name.startswith("ament_") or self.workspace.index.is_key(name)
            waiting += [need for need in needs if need not in found]
            found.update(needs)
        return frozenset(found), known

    def is_declared_beside(self, names: Iterable[str]) -> bool:
        """Return whether the repository's other packages declare or bring one of some names."""
        names = [*names]
        here = next((each for each in self.workspace.repositories if self.facts.folder in each), None)
        if any(is_declared_by_others(name, self.facts, here, self.workspace) for name in names):
            return True
        return not brought_in(here, self.workspace).keys().isdisjoint(names)

    def is_lacked_by_releases(self, names: Iterable[str]) -> bool:
        """Return whether only who installs the package alone lacks what it does not declare, as a release does.

        rosdep installs what any package of the repository declares; but colcon builds a package of the workspace only
        where it is asked for all, or a package that is asked for declares it.
        """
        names = [*names]
        return not any(map(self.workspace.named, names)) and self.is_declared_beside(names)

    def is_installed_otherwise(self, names: Iterable[str]) -> bool:
        """Return whether the repository installs one of some names by lists or commands of its own.

        They serve nobody who installs a release.
        """
        return self.installs.has(names) and not self.release.is_made

    @cached_property
    def installs(self) -> SystemInstalls:
        return SystemInstalls(self.release.files, self.workspace)

    @cached_property
    def distribution(self) -> OlderDistribution:
        """The distributions that the repository names."""
        return OlderDistribution(self.release.files)

    @cached_property
    def hidden(self) -> HiddenPackages:
        """The packages that lie where colcon does not look; imported where a name is known nowhere."""
        from .hidden_packages import HiddenPackages

        return HiddenPackages(self.release.files, self.workspace)

    @cached_property
    def commented_out(self) -> frozenset[str]:
        """The dependencies in comments: they were left out on purpose."""
        comments = "\n".join(comment.text for comment in self.manifest.document.comments)
        return frozenset(COMMENTED_DEPENDENCY.findall(comments))

    @cached_property
    def for_other_distributions(self) -> frozenset[str]:
        """What is declared for distributions of ROS 2 alone that are supported no more: people of these have it."""
        gone = (
            d for d in self.manifest.dependencies if "$ROS_DISTRO" in (d.condition or "") and not d.active(Targets())
        )
        return frozenset(d.name for d in gone)

    def is_needed_by(self, name: str) -> bool:
        """Return whether a package of the workspace depends on this one: a dependency on it would be a cycle."""
        seen: set[str] = set()
        waiting = [name]
        while waiting:
            facts = self.workspace.named(waiting.pop())
            if facts is not None and facts.name not in seen:
                seen.add(facts.name)
                waiting += [need.name for need in facts.dependencies if need.tag != "doc_depend"]
            if self.facts.name in waiting:
                return True
        return False


def metapackage_members(name: str, facts: PackageFacts | None) -> Iterable[str]:
    """Return the members of a metapackage of the workspace or of the table; nothing for any other package."""
    if facts is None:
        return rows("metapackages.txt").get(name, ())
    return [need.name for need in facts.dependencies] if facts.is_metapackage else ()
