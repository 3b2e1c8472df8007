"""Whether all packages that CMake looks for are known: an unknown one may find or define anything."""

from __future__ import annotations

from ...package.cmake.cmake_project import CMake
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.names import NameKind


def is_known_package(name: str, workspace: Workspace) -> bool:
    """Return whether a name that CMake looks for is that of a package here, of a released one, or of a library."""
    return workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY) or bool(keys_for_cmake(name))


def are_all_known(cmake: CMake, workspace: Workspace) -> bool:
    """Return whether each package that CMake looks for is known, and defines no commands or variables of its own."""
    names = {each.name for each in cmake.packages}
    facts = (workspace.named(name) for name in names)
    return all(is_known_package(name, workspace) for name in names) and not any(map(may_define, facts))


def may_define(facts: PackageFacts | None) -> bool:
    """Return whether a package of the workspace may be there for its CMake files: it has nothing else for others."""
    if facts is None or not facts.is_ament:
        return False
    return not (facts.is_compiled or facts.interfaces or facts.modules or facts.header_files)
