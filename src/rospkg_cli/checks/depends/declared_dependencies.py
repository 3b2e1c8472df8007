"""What package.xml declares: whether a package that is used is declared, directly or through others."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.manifest import BUILD_TYPES
from ..repository.released import Release
from .brought_dependencies import (
    Bringer,
)
from .dependency_bringers import DependencyBringers
from .misnamed_dependencies import MisnamedDependencies
from .transitive_dependencies import with_members

if TYPE_CHECKING:
    from .installed_otherwise import InstalledOtherwise

COMMENTED_DEPENDENCY = regex(r"(?:<|^\s*)\w*depend\b[^>]*>\s*([\w.-]+)\s*<", re.MULTILINE)
"""A dependency in a comment, be the comment made of the tag's own brackets: `<!-- depend>a</depend -->`."""


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
        active = (each.name for each in self.manifest.dependencies if each.active(Targets()))
        return frozenset(with_members(active, self.workspace))

    @cached_property
    def misnamed(self) -> MisnamedDependencies:
        return MisnamedDependencies(self.manifest, self.facts, self.workspace)

    @cached_property
    def brings(self) -> DependencyBringers:
        return DependencyBringers(self.names, self.misnamed, self.facts, self.workspace)

    @cached_property
    def otherwise(self) -> InstalledOtherwise:
        from .installed_otherwise import InstalledOtherwise  # most packages declare what they use

        return InstalledOtherwise(self.facts, self.workspace, self.release)

    def has(self, names: Iterable[str]) -> bool:
        """Return whether one of some names is declared, or is the package itself, or can't be declared."""
        return any(map(self.has_name, names))

    def has_to_run(self, name: str) -> bool:
        """Return whether a package is declared, or setup.py puts its wrong name into the ament index (SET401)."""
        return self.has_name(name) or self.workspace.is_marked(name)

    def has_name(self, name: str) -> bool:
        if name not in self._had:
            is_own = name in self.names or name == self.facts.name
            self._had[name] = is_own or self.is_needed_by(name) or self.misnamed.has(name)
        return self._had[name]

    @cached_property
    def _had(self) -> dict[str, bool]:
        """The answers of `has_name` so far: rules ask for the same hundreds of names."""
        return {}

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

    @cached_property
    def commented_out(self) -> frozenset[str]:
        """The dependencies in comments of package.xml: they are left out on purpose."""
        comments = "\n".join(comment.text for comment in self.manifest.document.comments)
        return frozenset(COMMENTED_DEPENDENCY.findall(comments))

    @cached_property
    def for_other_distributions(self) -> frozenset[str]:
        """What is declared under conditions that hold only for distributions of ROS 2 which are no longer supported."""
        gone = (
            d for d in self.manifest.dependencies if "$ROS_DISTRO" in (d.condition or "") and not d.active(Targets())
        )
        return frozenset(d.name for d in gone)

    def bringer(self, names: Iterable[str], *, runs: bool) -> Bringer | None:
        return self.brings.bringer(names, runs=runs)

    def bringers(self, names: Iterable[str], *, runs: bool) -> Mapping[str, Bringer]:
        return self.brings.bringers(names, runs=runs)
