"""What `rospkg inspect` reports of a package: the install table, the interfaces, and what is unknown."""

from __future__ import annotations

from collections.abc import Iterator

from ..light_dataclasses import dataclass
from ..ros.distros import Targets
from ..source import Source
from ..unreadable import Unreadable, UnreadableError
from .cmake.cmake_project import CMake
from .collect_facts import collect_facts
from .file_role import role_of
from .install_table import InstallKind, InstallTable, UnknownPart
from .launch.launch_file import LaunchFile
from .package import Package
from .package_facts import NOWHERE

EVERYTHING: tuple[InstallKind, ...] = ("executable", "share", "module")
SAY_WHAT_IS_INSTALLED = ("package.xml", "setup.py", "setup.cfg", "CMakeLists.txt")


@dataclass(frozen=True)
class RegisteredComponent:
    """A class that can be loaded into a container."""

    name: str
    target: str
    """The library of CMake that holds it."""
    executable: str
    """What runs it alone, "" for nothing."""
    path: str
    offset: int


@dataclass(frozen=True)
class Inspection:
    name: str
    folder: str
    """Relative to the root of the run."""
    build_type: str
    table: InstallTable
    interfaces: tuple[str, ...]
    components: tuple[RegisteredComponent, ...]
    launch: tuple[LaunchFile, ...]
    """The launch files for ROS 2, but those of tests."""
    sources: dict[str, Source]
    """The files that the table refers to, for lines and columns."""

    def position(self, path: str, offset: int) -> tuple[int, int]:
        """Return the line and column of an offset in a file of the package, both from 1."""
        source = self.sources.get(path)
        return source.position(offset) if source else (1, 1)


def inspect_package(package: Package, fallback: str, targets: Targets) -> Inspection:
    """Return what the build installs; `fallback` names a package whose package.xml can't be read."""
    facts = collect_facts(package, targets, package.folder, fallback)
    broken = [each for each in package.unreadable() if each.path in SAY_WHAT_IS_INSTALLED]
    table = package.parts(InstallTable).only or unread(facts.build_type, broken)
    components = tuple(registered(package))
    paths = {each.path for part in (table.rows, table.unknown, components) for each in part}
    return Inspection(
        name=facts.name,
        folder=package.folder,
        build_type=facts.build_type,
        table=table,
        interfaces=tuple(sorted(facts.interfaces)),
        components=components,
        launch=launch_files(package),
        sources=readable(package, paths),
    )


def registered(package: Package) -> Iterator[RegisteredComponent]:
    """Yield the components whose names are known, in the order of their names."""
    cmake = package.parts(CMake).only
    found = [component for component in cmake.components if component.plugin.is_known] if cmake is not None else []
    for each in sorted(found, key=lambda component: component.plugin.text):
        executable = each.executable.text if each.executable and each.executable.is_known else ""
        target = each.target.text if each.target.is_known else ""
        yield RegisteredComponent(each.plugin.text, target, executable, each.plugin.path, each.plugin.span.start)


def launch_files(package: Package) -> tuple[LaunchFile, ...]:
    found = [file for file in package.parts(LaunchFile).good if role_of(file.path) == "launch" and not file.is_ros1]
    return tuple(sorted((file for file in found if file.has_entry_point), key=lambda file: file.path))


def unread(build_type: str, broken: list[Unreadable]) -> InstallTable:
    """Return the table of a package of which nothing is known, and why."""
    why = broken[0] if broken else f"build type `{build_type}` is not known here"
    path, span = (broken[0].path, broken[0].span) if broken else ("package.xml", NOWHERE)
    return InstallTable((), tuple(UnknownPart(what, why, path, span) for what in EVERYTHING))


def readable(package: Package, paths: set[str]) -> dict[str, Source]:
    found = {}
    for path in sorted(path for path in paths if path):
        try:
            found[path] = package.files.source(path)
        except UnreadableError:
            continue
    return found
