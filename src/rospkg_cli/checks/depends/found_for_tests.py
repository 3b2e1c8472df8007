"""Packages that CMake looks for only where tests are built, and that targets outside of tests are linked with."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.find_package import FoundPackage
from ...package.cmake.target_links import TargetLink, TargetLinks
from .brought_by_links import BEFORE_JAZZY, BroughtByLinks
from .linked_at_run_time import package_name
from .undeclared_includes import IncludeDependencies


@dataclass(frozen=True, slots=True)
class FoundForTests:
    found: FoundPackage
    link: TargetLink
    may_be_brought: bool
    """Whether another package that is found may look for it."""


def found_for_tests(includes: IncludeDependencies) -> Iterator[FoundForTests]:
    """Yield each package once, at the first target that is linked with it; nothing that comes with another one."""
    cmake = includes.cmake
    if not includes.declared.is_checked or not cmake.is_complete or cmake.reads_unknown_files or cmake.only_tests:
        return
    built = {each.name for each in cmake.packages if not each.call.testing}
    tested = {each.name: each for each in cmake.packages if each.call.testing and each.name not in built}
    others = BroughtByLinks(frozenset(built), includes.declared.workspace)
    brought = others.within(BEFORE_JAZZY) if tested else set[str]()
    for link in TargetLinks(cmake).all if tested else ():
        target, name = cmake.target(link.target), package_name(includes, link)
        is_own = target is not None and not (target.call.testing or target.call.maybe or link.call.testing)
        if is_own and not link.call.maybe and name in tested and cmake.target(link.word.text) is None:
            found = tested.pop(name)
            if name not in brought:
                may_be = not brought.isdisjoint(includes.find_packages.provided.of(name)) or bool(others.strangers)
                yield FoundForTests(found, link, may_be)
