"""A package of which single files can be read: at a place of one, the others do not matter."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

from ..languages.yaml.nodes import documents
from ..light_dataclasses import dataclass
from ..package.interfaces.interface_file import InterfaceFile
from ..package.interfaces.reader import read as read_interface
from ..package.launch.launch_file import LaunchFile
from ..package.launch.read_launch_files import LaunchReader
from ..package.package import Package
from ..package.params.parameter_file import ParameterFile
from ..package.params.read_parameter_files import is_parameter_file
from ..package.python_modules import PythonModules
from ..package.urdf.reader import robot_file
from ..package.urdf.robot_file import RobotFile
from ..unreadable import UnreadableError

M = TypeVar("M", InterfaceFile, RobotFile, LaunchFile, ParameterFile)


@dataclass
class LookupPackage(Package):
    def __post_init__(self) -> None:
        super().__post_init__()
        self._files: dict[tuple[type, str], Any] = {}

    def file(self, kind: type[M], path: str) -> M | None:
        """Return the model of one file; None where it can't be read, or is of another kind."""
        if (kind, path) not in self._files:
            try:
                self._files[kind, path] = ONE[kind](self, path)
            except UnreadableError:
                self._files[kind, path] = None
        return cast("M | None", self._files[kind, path])


def launch_file(package: Package, path: str) -> LaunchFile | None:
    return LaunchReader(package.files, PythonModules(package.files)).read(path)


def parameter_file(package: Package, path: str) -> ParameterFile | None:
    source = package.files.source(path)
    return ParameterFile(source, tuple(documents(source))) if is_parameter_file(source) else None


ONE: dict[type, Callable[[Package, str], Any]] = {
    InterfaceFile: lambda package, path: read_interface(package.files, package.files.source(path)),
    RobotFile: lambda package, path: robot_file(package.files.source(path)),
    LaunchFile: launch_file,
    ParameterFile: parameter_file,
}
"""Reads one file; raises UnreadableError."""
