"""Names of dependencies that are wrong even without a fetched index, and the intended ones (DEP001)."""

from __future__ import annotations

from collections.abc import Callable

from ...package.dependency import Dependency
from ...ros.aliases import key_for_apt
from .declared_dependencies import DeclaredDependencies
from .intended_names import key_of_cmake_name
from .plain_projects import advice_for_project
from .similar_names import SimilarNames
from .wrong_dependency_name import WrongDependencyName
from .wrong_python_names import of_module, of_pip, of_python_2, of_python_itself


def wrong_name(
    declared: DeclaredDependencies, dependency: Dependency, *, misspelt: bool = True
) -> WrongDependencyName | None:
    """Return what is wrong with a name that no package and no key has; None where nothing is certain.

    A rosdep key without a rule for any supported Ubuntu counts as unknown, too. Without `misspelt`, similar names are
    not suggested.
    """
    finders = (*ELSEWHERE, of_typo) if misspelt else ELSEWHERE
    return next((found for find in finders if (found := find(declared, dependency)) is not None), None)


def several(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """Several names in one tag."""
    parts = dependency.name.replace(",", " ").split()
    if len(parts) < 2:
        return None
    lines = " ".join(f"<{dependency.tag}>{part}</{dependency.tag}>" for part in parts)
    return WrongDependencyName(f"is {len(parts)} names in one tag", advice=f"write {lines}", parts=tuple(parts))


def of_cmake(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """The name for find_package: `OpenCV`."""
    key = key_of_cmake_name(dependency.name)
    return WrongDependencyName("is what CMake calls it", key) if key else None


def of_ubuntu(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """The name of the package of Ubuntu."""
    key = key_for_apt(dependency.name, declared.workspace.index)
    return WrongDependencyName("is its name in Ubuntu", key) if key is not None else None


def of_family(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """The name of a package of the workspace without the prefix that all of them have: `arm` for `acme_arm`."""
    if declared.workspace.folder_of_project(dependency.name):
        return None
    member = SimilarNames(declared.workspace).with_family_prefix(dependency.name)
    return WrongDependencyName("is no known ROS package, here or elsewhere", member) if member is not None else None


def of_typo(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """A misspelt name of a package or key."""
    intended = SimilarNames(declared.workspace).intended(dependency.name)
    if intended is None or without_version(intended) == without_version(dependency.name):
        return None
    start = "is no known ROS package or rosdep key"
    if for_project := advice_for_project(dependency.name, declared.workspace):
        return WrongDependencyName(start, advice=for_project)
    return WrongDependencyName(start, intended, f"did you mean `{intended}`?")


def without_version(name: str) -> str:
    """Return a name without the digits at its end: or before `-dev`: `gz-plugin3` is no misspelt `gz-plugin2`."""
    bare = name.removesuffix("-dev")
    return bare.rstrip("0123456789.-_") + name[len(bare) :]


ELSEWHERE: tuple[Callable[[DeclaredDependencies, Dependency], WrongDependencyName | None], ...] = (
    several, of_cmake, of_python_itself, of_python_2, of_pip, of_module, of_ubuntu, of_family,
)  # fmt: skip
