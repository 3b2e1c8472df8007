"""Where a dependency that is to be declared would come from, which decides what to advise."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Literal

from ...package.missing_repositories import COMMON
from ...ros.distros import DISTROS, Targets
from ...ros.names import NameKind
from ...ros.rosdep import NOT_THERE
from ...suggest import near_names
from .circles import circle_with
from .commented_installs import is_installed_by_comment
from .declared_dependencies import DeclaredDependencies
from .similar_names import SimilarNames
from .split_distributions import split_distributions

NameSource = Literal["released", "pip", "unknown"]


def source_of(declared: DeclaredDependencies, name: str) -> NameSource:
    """Return whether a name is released or around, is installed from PyPI alone, or is known nowhere.

    A name that only an incomplete workspace could explain counts as unknown: rosdep does not know it either.
    """
    workspace = declared.workspace
    if workspace.is_available(name) or workspace.kind_of(name) is NameKind.PACKAGE:
        return "released"
    index = workspace.index
    if index.is_package(name):
        return "released"
    if not index.is_key(name):
        return "unknown"
    ways = {index.installer(name, each) for each in Targets()}
    return "pip" if "pip" in ways and ways <= {"pip", "-"} else "released"


def only_distros(declared: DeclaredDependencies, name: str) -> list[str]:
    """Return the distributions that alone have a released package or a rule for a key; nothing where all have it.

    Who declares it keeps `rosdep install` from working on the others. What the oldest has and newer ones lack, as yet,
    counts as there for a package; a key of Debian that is gone does not come back.
    """
    index = declared.workspace.index
    if declared.workspace.is_available(name):
        return []
    if index.is_key(name):
        ruled = [each.name for each in Targets() if index.installer(name, each) != NOT_THERE]
        return ruled if len(ruled) < len([*Targets()]) else []
    having = index.packages.get(name, ())
    oldest, *newer = (each.name for each in DISTROS)
    return [] if oldest in having else [each for each in newer if each in having]


def is_left_out(declared: DeclaredDependencies, name: str) -> bool:
    """Return whether a dependency is missing on purpose: package.xml has it in a comment or for older distributions
    alone, or it may come otherwise.

    A package that no distribution has may lie in a repository that a `.repos` file lists, in an empty submodule, in
    another one of the same family, or here where colcon does not look, and be built by a container or a script.
    What only PyPI has is left to pip, since a key of pip keeps a package from being released.
    """
    source = source_of(declared, name)
    is_elsewhere = source == "pip" or (source == "unknown" and not declared.workspace.is_complete)
    is_elsewhere = is_elsewhere or (source == "unknown" and is_of_family(declared, name))
    is_elsewhere = is_elsewhere or (source == "unknown" and declared.otherwise.hidden.is_built(name))
    return is_elsewhere or name in declared.commented_out or name in declared.for_other_distributions


def is_of_family(declared: DeclaredDependencies, name: str) -> bool:
    """Return whether an unknown package begins like the one that needs it, and like no other one here.

    Its makers have a repository for each, and build them in one workspace.
    """
    own = declared.facts.name
    family = own.partition("_")[0]
    if family == own or family.rstrip("0123456789") in COMMON or not name.startswith(f"{family}_"):
        return False
    others = declared.workspace.names - {own}
    is_alone = not any(each.startswith(f"{family}_") for each in others)
    return is_alone and not near_names(name, [own]) and SimilarNames(declared.workspace).intended(name) is None


def is_unmet(declared: DeclaredDependencies, name: str, serving: Iterable[str] = ()) -> bool:
    """Return whether an undeclared dependency, or one of the names `serving` it, is likely to be there all the same.

    It is left out on purpose, another package of a repository without releases declares it, a list or a command of the
    repository or a comment of package.xml installs it, or declaring it would make a circle.
    """
    names = (name, *serving)
    is_there = is_installed_with_others(declared, names) or declared.otherwise.is_by_command(names)
    is_there = is_there or is_installed_by_comment(declared.manifest, names)
    return is_there or is_left_out(declared, name) or circle_with(declared, name) is not None


def is_unmet_at_run(declared: DeclaredDependencies, name: str, serving: Iterable[str] = ()) -> bool:
    """Return `is_unmet` for a dependency that only runs need, which may be left out so that rosdep does not stop.

    It is also unmet where some of the distributions that the repository names have it and others lack it.
    """
    return is_unmet(declared, name, serving) or split_distributions(declared, name).is_for_some


def is_installed_with_others(declared: DeclaredDependencies, names: Collection[str]) -> bool:
    """Return whether rosdep installs it for another package of the repository, and nothing shows a release."""
    is_there = declared.otherwise.is_lacked_by_releases(names) and is_installable(declared, names)
    return is_there and not declared.release.is_made


def is_installable(declared: DeclaredDependencies, names: Iterable[str]) -> bool:
    """Return whether it is known where one of some names comes from."""
    return any(source_of(declared, name) != "unknown" for name in names)
