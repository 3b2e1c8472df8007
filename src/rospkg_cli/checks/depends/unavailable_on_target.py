"""Names of dependencies that a target lacks: why, and the name to suggest instead (DEP001)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property

from ...languages.rep149_condition import may_hold
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ...package.workspace import Workspace
from ...ros.distros import DISTROS, Distro, Targets
from ...ros.name_suggestions import suggested_name
from ...ros.names import Names
from ...ros.rosdep import CODENAMES
from ..enumeration import enumerated
from .plain_projects import advice_for_project
from .similar_names import SimilarNames

NO_PACKAGE = regex(r"python3?-.*|lib.*-dev|.*[^\w-].*")
"""Names that no ROS package has: those of Debian's libraries, and what REP-144 forbids."""


@dataclass(frozen=True)
class UnavailableName:
    name: str
    workspace: Workspace
    distros: tuple[Distro, ...]
    """The targets that need it and lack it."""

    @property
    def index(self) -> Names:
        return self.workspace.index

    @cached_property
    def for_project(self) -> str:
        return advice_for_project(self.name, self.workspace)

    @cached_property
    def suggestion(self) -> str | None:
        """The similar name of something that the target or the workspace has; None where another distribution or a
        plain CMake project has the name, or nothing has a similar one."""
        if self.other_distros or self.for_project:
            return None
        there = Targets(tuple(each.name for each in self.distros))
        return suggested_name(self.name, self.index, there) or SimilarNames(self.workspace).renamed(self.name)

    @property
    def is_certain(self) -> bool:
        """Whether it is certain enough to be reported, though packages of the workspace may not be here."""
        if self.workspace.is_complete or self.for_project or NO_PACKAGE.fullmatch(self.name):
            return True
        if self.workspace.may_lack(self.name):
            return False
        return bool(self.suggestion) or bool(self.workspace.missing_repositories)

    @property
    def may_be_elsewhere(self) -> bool:
        """Whether a repository that is not here may hold it after all, under whatever name."""
        is_settled = self.workspace.is_complete or self.suggestion or self.for_project
        return not (is_settled or NO_PACKAGE.fullmatch(self.name))

    @cached_property
    def other_distros(self) -> list[str]:
        """The distributions that have a package of that name."""
        having = self.index.packages.get(self.name, ())
        return [each.name for each in DISTROS if each.name in having]

    @property
    def reason(self) -> str:
        if self.other_distros:
            lacking = enumerated(each.name for each in self.distros)
            return f"is released for {enumerated(self.other_distros)} and not for {lacking}"
        if self.index.is_key(self.name):
            return f"is a rosdep key without a rule for Ubuntu {enumerated(each.ubuntu for each in self.distros)}"
        return "is no ROS package and no rosdep key"

    @property
    def rosdep_error(self) -> str:
        if self.index.is_key(self.name) and not self.other_distros:
            return f"No definition of [{{}}] for OS version [{CODENAMES[self.distros[0].ubuntu]}]"
        return "Cannot locate rosdep definition for [{}]"

    @property
    def advice(self) -> str:
        if self.for_project:
            return self.for_project
        if self.other_distros:
            lacking = " and ".join(f"$ROS_DISTRO != {each.name}" for each in self.distros)
            return f'add it to the workspace, or do without it there: condition="{lacking}"'
        if self.suggestion:
            return f"did you mean `{self.suggestion}`?"
        if self.index.is_key(self.name):
            return ""
        if self.may_be_elsewhere:
            return "no listed repository that is missing here is called like it: is it in one of them?"
        return "is it a package that the workspace lacks?"


def lacking_distros(same: Sequence[Dependency], workspace: Workspace, targets: Targets) -> tuple[Distro, ...]:
    """Return the targets that certainly need the name of some dependencies and certainly lack it.

    Without named targets: all that need it, or none if one of them has it.
    """
    name = same[0].name
    without = [each for each in targets if workspace.resolves(name, each) is False]
    needing = [each for each in targets if is_needed_on(each, same)] if without else []
    found = [each for each in needing if each in without]
    if not targets.names:
        return tuple(found) if found == needing else ()
    if workspace.index.is_package(name):
        found = [each for each in found if each.end_of_life]  # packages come and go in Rolling, as they are rebuilt
    return tuple(found)


def is_needed_on(distro: Distro, same: Iterable[Dependency]) -> bool:
    """Return whether one of some dependencies is active for a distribution, or may be, by an environment variable."""
    environments = Targets((distro.name,)).environments()
    return any(may_hold(each.condition, environments) for each in same)
