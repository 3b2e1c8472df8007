"""Environment hooks of a CMake package that may set PYTHONPATH."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...package.cmake.cmake_project import CMake

SETS = "PYTHONPATH"


def may_set_python_path(cmake: CMake) -> bool:
    """Return whether an environment hook may set PYTHONPATH."""
    return any(may_set_path(cmake, call) for call in cmake.calls)


def may_set_path(cmake: CMake, call: EvaluatedCommand) -> bool:
    """Return whether a call adds an environment hook that may set PYTHONPATH; hooks of the package are read."""
    if call.name != "ament_environment_hooks":
        return False
    files, paths = cmake.package_files, [path_in_package(each, call.folder) for each in call.texts]
    return any(path is None or not files.exists(path) or SETS in files.readable_text(path) for path in paths)
