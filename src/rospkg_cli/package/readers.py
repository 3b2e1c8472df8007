"""The reader of each model: the one table that the engine and joined rule inputs use."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import PurePosixPath
from typing import Any

from ..files import ReaderInput
from ..languages.cmake.file import CMakeFile
from ..languages.cpp.file import CppFile
from ..languages.cpp.read import read_cpp_files
from ..languages.python.file import PythonFile
from ..unreadable import Unreadable
from .behavior_trees import BehaviorTree, read_behavior_trees
from .changelog import Changelog, read_changelog
from .cmake.cmake_project import CMake
from .cmake.read_cmake import read_cmake, read_cmake_files
from .install_table import InstallTable
from .interfaces.interface_file import InterfaceFile
from .interfaces.reader import read_interfaces
from .launch.launch_file import LaunchFile
from .launch.read_launch_files import read_launch_files
from .manifest import Manifest, read_manifest
from .params.parameter_file import ParameterFile
from .params.parameter_library import ParameterLibrary, read_parameter_libraries
from .params.read_parameter_files import read_parameter_files
from .plugins.description import PluginDescription
from .plugins.loaders import PluginLoaders, read_plugin_loaders
from .plugins.read_descriptions import read_plugin_descriptions
from .python.python_imports import PackageImports, read_package_imports
from .python_modules import PythonModules, read_installed_modules, read_modules
from .read_install_table import read_install_table
from .setup.parse_setup_cfg import read_setup_cfg
from .setup.read_setup_py import read_setup_py
from .setup.setup_cfg import SetupCfg
from .setup.setup_py import SetupPy
from .urdf.reader import read_robot_files
from .urdf.robot_file import RobotFile

READERS: dict[type, Callable[[ReaderInput], Iterable[Any | Unreadable]]] = {
    Manifest: read_manifest,
    Changelog: read_changelog,
    SetupCfg: read_setup_cfg,
    SetupPy: read_setup_py,
    PythonModules: read_modules,
    PythonFile: read_installed_modules,
    InstallTable: read_install_table,
    CMake: read_cmake,
    CMakeFile: read_cmake_files,
    CppFile: read_cpp_files,
    InterfaceFile: read_interfaces,
    PluginDescription: read_plugin_descriptions,
    PluginLoaders: read_plugin_loaders,
    ParameterFile: read_parameter_files,
    ParameterLibrary: read_parameter_libraries,
    RobotFile: read_robot_files,
    BehaviorTree: read_behavior_trees,
    PackageImports: read_package_imports,
    LaunchFile: read_launch_files,
}
"""A reader yields models and Unreadables; it may raise UnreadableError where it reads a single file."""

ONLY_READ_BY: dict[str, tuple[type, ...]] = {
    "package.xml": (Manifest,),
    "setup.cfg": (SetupCfg,),
    "CMakeLists.txt": (CMake, CMakeFile),
    ".cmake": (CMake, CMakeFile),
    ".msg": (InterfaceFile,),
    ".srv": (InterfaceFile,),
    ".action": (InterfaceFile,),
    ".yaml": (ParameterFile, LaunchFile),
}
"""The models in which a file of that name or suffix can be found unreadable; any model where it is not listed."""


def readers_of(paths: Iterable[str]) -> Iterable[type]:
    """Return the models to read in order to know whether some files can be read; all where no path is given."""
    found: dict[type, None] = {}
    for path in paths:
        name = PurePosixPath(path).name
        kinds = ONLY_READ_BY.get(name) or ONLY_READ_BY.get(PurePosixPath(name).suffix)
        if kinds is None:
            return READERS
        found |= dict.fromkeys(kinds)
    return found or READERS
