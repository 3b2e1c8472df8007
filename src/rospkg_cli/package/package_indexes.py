"""Indexes of the packages of a workspace: by name, dependency, folder of headers, and base class of plugins."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import takewhile

from ..ros.manifest import BUILDS
from ..ros.plugins import LOADED_FROM
from .package_facts import PackageFacts


def of_one_name(packages: Iterable[PackageFacts]) -> tuple[tuple[PackageFacts, ...], ...]:
    """Return the packages of each name that several have."""
    found: dict[str, list[PackageFacts]] = {}
    for facts in packages:
        found.setdefault(facts.name, []).append(facts)
    return tuple(tuple(each) for each in found.values() if len(each) > 1)


def by_dependency(packages: Iterable[PackageFacts]) -> dict[str, list[PackageFacts]]:
    """Return, by name, the packages that declare a dependency, whatever its tag."""
    found: dict[str, list[PackageFacts]] = {}
    for facts in packages:
        for name in dict.fromkeys(need.name for need in facts.dependencies):
            found.setdefault(name, []).append(facts)
    return found


def by_build_dependency(packages: Iterable[PackageFacts]) -> dict[str, set[str]]:
    """Return, by name, the packages that need one for their build; without ament_python, which finds none by CMake."""
    found: dict[str, set[str]] = {}
    for facts in (each for each in packages if each.build_type != "ament_python"):
        for need in facts.dependencies:
            if need.tag in BUILDS:
                found.setdefault(need.name, set()).add(facts.name)
    return found


def by_header_folder(packages: Iterable[PackageFacts]) -> dict[str, set[str]]:
    """Return, by the folder of headers, the packages that have it."""
    found: dict[str, set[str]] = {}
    for facts in packages:
        for folder in facts.headers:
            found.setdefault(folder, set()).add(facts.name)
    return found


def loaders_by_base(packages: Iterable[PackageFacts], is_package: Callable[[str], bool]) -> dict[str, set[str]]:
    """Return, by the base class of plugins, the packages whose loaders load them."""
    found = {base: {package} for base, package in LOADED_FROM.items()}
    for facts in packages:
        for package, base in facts.loaders:
            if is_package(package):
                found.setdefault(base, set()).add(package)
    return found


def shared_folders(one: str, other: str) -> int:
    """Return how many folders two paths have in common, from the outermost on."""
    pairs = zip(one.split("/"), other.split("/"), strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
