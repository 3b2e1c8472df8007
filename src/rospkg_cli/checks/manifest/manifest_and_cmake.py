"""Rule input: a manifest together with the CMake files of its package."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.project_name import PACKAGE_ENDS
from ...package.manifest import Manifest
from ...ros.distros import Targets

IDLE = frozenset(
    "cmake_minimum_required project cmake_policy find_package message set unset list string option include_guard "
    "add_definitions add_compile_options add_compile_definitions ament_package enable_testing return".split()
)
"""Commands that build and install nothing, apart from the files that ament_package writes for CMake."""

CODE = (".py", ".cpp", ".cc", ".c", ".hpp", ".h", ".rs", ".msg", ".srv", ".action", ".launch", "Makefile", "Cargo.toml")


@dataclass(frozen=True)
class ManifestAndCMake:
    """There is none for a package whose CMake files can't be read."""

    manifest: Manifest
    cmake: CMake | None
    files: PackageFiles
    targets: Targets

    @cached_property
    def found(self) -> frozenset[str]:
        """The names that `find_package` is called with, in any file."""
        return frozenset(each.name for each in self.cmake.packages) if self.cmake else frozenset()

    @property
    def found_to_build(self) -> frozenset[str]:
        """The names that `find_package` is called with, but for tests alone."""
        packages = self.cmake.packages if self.cmake else ()
        return frozenset(each.name for each in packages if not each.call.testing)

    def requires(self, name: str) -> bool:
        """Return whether the configuration certainly fails without a part of ament_cmake, as DEP104 reports."""
        found = [each for each in self.cmake.packages if each.name == name] if self.cmake else []
        return name != "ament_cmake" and any(
            each.is_required and each.word.is_known and not (each.word.maybe or each.call.maybe) for each in found
        )

    @property
    def ends_a_package(self) -> bool:
        """Whether CMake calls `ament_package`, by whatever name."""
        return self.cmake is not None and self.cmake.ends_a_package

    @property
    def may_be_started(self) -> bool:
        """Whether it has programs, components or launch files, as far as CMake is known."""
        cmake = self.cmake
        if cmake is None or not cmake.is_complete or any(path.startswith("launch/") for path in self.files.paths):
            return True
        if any("register_node" in call.name or "PROGRAMS" in call.texts for call in cmake.calls):
            return True
        from .run_programs import has_run_programs  # most packages name their build type

        return has_run_programs(cmake, self.files, self.manifest.name)

    @property
    def installs_python(self) -> bool:
        """Whether CMake builds or installs Python packages, so that a setup.py next to CMakeLists.txt is intended."""
        words = ("ament_cmake_python", "catkin", "Python3", "PythonInterp", "pybind11", "pybind11_vendor")
        called = self.cmake is not None and self.cmake.named("ament_python_install_package")
        return bool(called) or not self.found.isdisjoint(words)

    @property
    def is_catkin(self) -> bool:
        """Whether it is a package of ROS 1: it depends on catkin, and on no package of ament."""
        names = {each.name for each in self.manifest.dependencies} | self.found
        return "catkin" in names and not any(name.startswith("ament_") for name in names)

    @property
    def is_left_to_ros1(self) -> bool:
        """Whether CMake builds it as a package of ROS 1 under a condition, and never as one of ROS 2."""
        if self.cmake is None or not self.cmake.is_complete:
            return False
        calls = [*self.cmake.calls, *self.cmake.unreachable]
        under_condition = [*(call for call in self.cmake.calls if call.maybe), *self.cmake.unreachable]
        is_made = any(call.name.endswith(PACKAGE_ENDS) for call in calls)
        return not is_made and any(call.name == "catkin_package" for call in under_condition)

    @property
    def does_nothing(self) -> bool:
        """Whether CMake neither builds nor installs anything, as in the folder of a program that npm builds."""
        if self.cmake is None or not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return False
        calls = (call for call in self.cmake.calls if not call.testing)
        is_empty = self.ends_a_package and not self.files.below("launch")
        return is_empty and all(call.name in IDLE for call in calls)

    @property
    def is_mark(self) -> bool:
        """Whether package.xml only marks a folder of files for other tools (Drake's PackageMap): it holds no code."""
        folders = {path.partition("/")[0] for path in self.files.paths if "/" in path}
        is_code = any(path.endswith(CODE) for path in self.files.paths)
        return bool(folders) and not (is_code or "launch" in folders or self.manifest.dependencies)

    @property
    def likely_build_type(self) -> str:
        """The build type that its files indicate; "" where they indicate none, or two."""
        if not self.files.exists("CMakeLists.txt"):
            return "ament_python" if self.files.exists("setup.py") else ""
        if self.ends_a_package or any(name.startswith("ament_cmake") for name in self.found):
            return "ament_cmake"
        return "" if self.files.exists("setup.py") or self.uses_wrappers else "cmake"

    @property
    def uses_wrappers(self) -> bool:
        """Whether `find_package` finds a package that may wrap ament_package in a command of another name."""
        return any(name.endswith("_cmake") for name in self.found)
