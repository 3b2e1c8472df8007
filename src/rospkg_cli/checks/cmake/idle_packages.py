"""Packages that have programs and whose CMakeLists.txt makes and installs nothing at all (CMK101)."""

from __future__ import annotations

from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import foreign_commands
from ...package.file_role import role_of
from ...package.install_table import InstallTable

PROGRAMS = ("scripts", "script", "bin", "nodes", "tools")
"""Folders of programs that need no building."""
SHEBANG = "#!"


def idle_programs(package: CMakePackage, table: InstallTable) -> list[str]:
    """Return the programs of the first of these folders, where nothing of the package is installed.

    A package that brings others has them, and its programs may be helpers.
    """
    needs = (need.tag for need in package.facts.dependencies)
    if not does_nothing(package, table) or any(tag in ("depend", "exec_depend") for tag in needs):
        return []
    files = package.cmake.package_files
    for folder in PROGRAMS:
        paths = [path for path in files.below(folder) if role_of(path) == "run" and not files.absent.is_ignored(path)]
        if programs := [path for path in paths if files.readable_text(path).startswith(SHEBANG)]:
            return programs
    return []


def does_nothing(package: CMakePackage, table: InstallTable) -> bool:
    """Return whether CMake certainly makes and installs nothing but package.xml."""
    cmake = package.cmake
    is_read = cmake.is_complete and cmake.ends_a_package and not cmake.reads_unknown_files and not table.unknown
    if not package.is_ament or not is_read or next(foreign_commands(cmake), None) is not None:
        return False
    makes = cmake.targets or cmake.interface_targets or cmake.functions
    does = any("install" in call.name or "export" in call.name for call in cmake.calls)
    return not makes and not does and all(row.source == "package.xml" for row in table.rows)
