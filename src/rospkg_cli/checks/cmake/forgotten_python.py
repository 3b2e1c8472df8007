"""The Python package of a CMake package's own name, which nothing installs and nothing here imports (CMK109)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.cmake.artifacts import PYTHON_MODULES
from ...package.cmake.foreign_commands import foreign_commands
from .python_path_hooks import may_set_python_path
from .uninstalled_python import PythonPackages


@dataclass(frozen=True)
class ForgottenPython:
    packages: PythonPackages

    def name(self) -> str:
        """Return the name of the package where a Python package of this name is not installed; "" where it is.

        It is "" too where CMake does not look for ament_cmake_python, and where a script or launch file imports it.
        """
        packages, cmake = self.packages, self.packages.package.cmake
        name = packages.package.facts.name
        found = any(each.name == "ament_cmake_python" and not each.call.maybe for each in cmake.packages)
        is_known = packages.table.knows("module") and cmake.is_complete and not cmake.reads_unknown_files
        folder, rows = packages.folders.get(name, name), packages.table.rows
        is_used = any(row.source.startswith(f"{folder}/") for row in rows if row.what != "executable")
        programs = {row.source for row in rows}
        files = [path for path in cmake.package_files.below(folder) if path.endswith(".py") and path not in programs]
        if not found or not is_known or is_used or self.has_other_ways:
            return ""
        if name not in packages.folders or not files[1:]:
            return ""
        is_reported = packages.names_no_folder or any(each.folder == name for each in packages.uninstalled())
        return "" if is_reported else name

    @property
    def has_other_ways(self) -> bool:
        """Whether the build may put modules where Python looks by other means."""
        cmake = self.packages.package.cmake
        hooks = cmake.named("generate_parameter_module") or may_set_python_path(cmake)
        bindings = any(target.call.name in PYTHON_MODULES for target in cmake.targets)
        return bool(cmake.interface_targets or hooks) or bindings or next(foreign_commands(cmake), None) is not None
