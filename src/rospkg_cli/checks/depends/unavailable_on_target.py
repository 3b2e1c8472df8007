"""A dependency that a target does not have: what it is called elsewhere, and what may be meant."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from ...package.manifest import Dependency
from ...package.workspace import Workspace
from ...ros.distros import DISTROS, Distro, Targets
from ...ros.name_suggestions import suggested_name
from ...ros.rosdep import CODENAMES


@dataclass(frozen=True)
class UnavailableDependency:
    dependency: Dependency
    workspace: Workspace
    targets: Targets
    distros: tuple[Distro, ...]
    """The targets that need it and lack it."""

    @property
    def name(self) -> str:
        return self.dependency.name

    @cached_property
    def meant(self) -> str | None:
        """The name of something that the target has, where one is called nearly so."""
        if self.elsewhere:
            return None
        return suggested_name(self.name, self.workspace.index, Targets(tuple(each.name for each in self.distros)))

    @cached_property
    def elsewhere(self) -> list[str]:
        """The distributions that have a package of that name."""
        having = self.workspace.index.packages.get(self.name, ())
        return [each.name for each in DISTROS if each.name in having]

    @property
    def why(self) -> str:
        if self.elsewhere:
            return f"is released for {joined(self.elsewhere)} and not for {joined(each.name for each in self.distros)}"
        if self.workspace.index.is_key(self.name):
            return f"is a rosdep key without a rule for Ubuntu {joined(each.ubuntu for each in self.distros)}"
        return "is no ROS package and no rosdep key"

    @property
    def fails(self) -> str:
        if self.workspace.index.is_key(self.name) and not self.elsewhere:
            return f"No definition of [{{}}] for OS version [{CODENAMES[self.distros[0].ubuntu]}]"
        return "Cannot locate rosdep definition for [{}]"

    @property
    def instead(self) -> str:
        if self.elsewhere:
            lacking = " and ".join(f"$ROS_DISTRO != {each.name}" for each in self.distros)
            return f'have it in the workspace, or do without it there: condition="{lacking}"'
        if self.meant:
            return f"did you mean `{self.meant}`?"
        return "" if self.workspace.index.is_key(self.name) else "is it a package that the workspace lacks?"


def joined(names: Iterable[str]) -> str:
    *others, last = dict.fromkeys(names)
    return f"{', '.join(others)} and {last}" if others else last
