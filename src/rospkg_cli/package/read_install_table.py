"""Make the install table of a package, for any build type, and its facts for other packages."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import NamedTuple

from ..files import ReaderInput
from ..languages.cmake.evaluated_command import path_in_package
from .cmake.build import is_built_with_cmake
from .cmake.cmake_project import CMake
from .install_table import PYTHON, InstallTable
from .manifest import Manifest
from .package_facts import UnknownField
from .setup.python_install_table import MARKERS, python_table
from .setup.setup_py import SetupPy


def read_install_table(reading: ReaderInput) -> Iterator[InstallTable]:
    """Yield the install table; none where nothing that is understood installs the package."""
    manifest, setup = reading.parts(Manifest).only, reading.parts(SetupPy).only
    if manifest is None or not manifest.name:
        return
    if is_built_with_cmake(reading):
        from .cmake.cmake_install_table import cmake_table

        for cmake in reading.parts(CMake).good:
            yield cmake_table(cmake, manifest.name)
    elif setup is not None:
        yield python_table(setup, manifest.name)


class InstalledFacts(NamedTuple):
    """The fields of PackageFacts that come from the install table."""

    executables: frozenset[str] = frozenset()
    misplaced_executables: frozenset[str] = frozenset()
    other_markers: frozenset[str] = frozenset()
    share_files: frozenset[str] = frozenset()
    modules: frozenset[str] = frozenset()
    unknown: frozenset[UnknownField] = frozenset({"executables", "share_files", "modules"})


def installed_facts(reading: ReaderInput, name: str) -> InstalledFacts:
    table = reading.parts(InstallTable).only
    if table is None:
        return InstalledFacts()
    unknown: set[UnknownField] = set()
    unknown |= {"executables"} if has_malformed(reading) or not table.knows("executable") else set()
    unknown |= set() if table.knows("share") else {"share_files"}
    unknown |= set() if table.knows("module") else {"modules"}
    unknown |= misplaced_by_cmake(reading, name) if is_built_with_cmake(reading) else set()
    return InstalledFacts(
        frozenset(path for path, _ in table.below(f"lib/{name}")),
        frozenset(PurePosixPath(row.destination).name for row in table.of("executable"))
        - {PurePosixPath(path).name for path, _ in table.below(f"lib/{name}")}
        | uninstalled_executables(reading),
        frozenset(path for path, _ in table.below(MARKERS)) - {name},
        frozenset(path for path, _ in table.below(f"share/{name}")),
        frozenset(filter(None, (module_name(path) for path, _ in table.below(PYTHON)))),
        frozenset(unknown),
    )


def misplaced_by_cmake(reading: ReaderInput, name: str) -> set[UnknownField]:
    """Return what goes elsewhere by one mistake: the name that `project()` has, the folder of the Python package.

    CMK001 and CMK102 report that one; what else it breaks need not be said.
    """
    found: set[UnknownField] = set()
    for cmake in reading.parts(CMake).good:
        found |= {"executables"} if cmake.project_name not in ("", name) else set()
        for rule in cmake.installs:
            if rule.call.name == "ament_python_install_package":
                folder = path_in_package(rule.items[0].text, rule.call.folder)
                found |= {"modules"} if folder and not reading.files.below(folder) else set()
    return found


def uninstalled_executables(reading: ReaderInput) -> frozenset[str]:
    """Return the executables that CMake builds and does not install; CMK103 reports them at their target."""
    from .cmake.uninstalled_targets import UninstalledTargets

    found = (each for cmake in reading.parts(CMake).good for each in UninstalledTargets(cmake).all())
    return frozenset(each.target.name for each in found if each.target.is_executable)


def has_malformed(reading: ReaderInput) -> bool:
    """Return whether an entry point is written in a way that leaves open what its executable is called."""
    setup = reading.parts(SetupPy).only
    return setup is not None and any(
        bool(each.fault if each.is_script else each.intended_group) for each in setup.entry_points
    )


def module_name(path: str) -> str:
    """Return the dotted name of an installed Python file or compiled module, "" for what is none."""
    pure = PurePosixPath(path)
    if pure.suffix not in (".py", ".so"):
        return ""
    return ".".join(pure.parent.parts if pure.stem == "__init__" else pure.with_suffix("").parts)
