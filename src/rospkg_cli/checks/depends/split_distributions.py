"""Which of the distributions that a repository names have a package that it does not declare, and which lack it."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...ros.distros import DISTROS, Targets
from ...ros.rosdep import NOT_THERE
from .declared_dependencies import DeclaredDependencies


@dataclass(frozen=True, slots=True)
class SplitDistributions:
    having: tuple[str, ...] = ()
    """The supported ones that have it, named or not; nothing where all of the named ones have it."""
    lacking: tuple[str, ...] = ()
    """The supported ones that lack it, named or not."""
    named: frozenset[str] = frozenset()
    """The supported ones that the pages of the repository name."""

    @property
    def is_for_some(self) -> bool:
        """Whether some of the named ones have it: a plain declaration stops rosdep on the others."""
        return not self.named.isdisjoint(self.having)

    @property
    def without(self) -> tuple[str, ...]:
        """The named ones that lack it."""
        return tuple(name for name in self.lacking if name in self.named)

    @property
    def condition(self) -> str:
        """The condition of a declaration for those that have it (REP-149); "" where no named one does."""
        if not self.is_for_some:
            return ""
        if len(self.having) <= len(self.lacking):
            return " or ".join(f"$ROS_DISTRO == {name}" for name in self.having)
        return " and ".join(f"$ROS_DISTRO != {name}" for name in self.lacking)


def split_distributions(declared: DeclaredDependencies, name: str) -> SplitDistributions:
    """Return which distributions have a package or a key, if one that the repository names lacks it; empty otherwise.

    The repository is asked last, for it has many pages.
    """
    having = having_it(declared, name)
    supported = [each.name for each in DISTROS]
    if not having or having.issuperset(supported):
        return SplitDistributions()
    named = declared.otherwise.distribution.intended.intersection(supported)
    if having.issuperset(named):
        return SplitDistributions()
    lacking = tuple(each for each in supported if each not in having)
    return SplitDistributions(tuple(each for each in supported if each in having), lacking, named)


def with_newest(having: list[str]) -> frozenset[str]:
    """Return these with the two newest where the one before them is among them: what is not released yet will be."""
    *_, before, newest, rolling = (each.name for each in DISTROS)
    return frozenset((*having, newest, rolling) if before in having else having)


def having_it(declared: DeclaredDependencies, name: str) -> frozenset[str]:
    """Return the supported distributions that have a released package or a rule for a key; nothing for what is here.

    A key of Debian that is gone does not come back.
    """
    index = declared.workspace.index
    if declared.workspace.is_available(name):
        return frozenset()
    if index.is_key(name) and not index.is_package(name):
        return frozenset(each.name for each in Targets() if index.installer(name, each) != NOT_THERE)
    return with_newest([each.name for each in DISTROS if each.name in index.packages.get(name, ())])
