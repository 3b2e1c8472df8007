"""What `rospkg inspect` tells of a package: the install table, interfaces, launch files, and what can't be told."""

from __future__ import annotations

from dataclasses import dataclass

from .install import InstallTable, What
from .launch.file import LaunchFile
from .package import Package
from .uses.roles import role_of

EVERYTHING: tuple[What, ...] = ("executable", "share", "module")
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


def launch_files(package: Package) -> tuple[LaunchFile, ...]:
    found = [file for file in package.parts(LaunchFile).good if role_of(file.path) == "launch" and not file.ros1]
    return tuple(sorted((file for file in found if file.entry), key=lambda file: file.path))
