"""Inputs of manifest rules: a manifest together with other parts of its package."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.project_name import PACKAGE_ENDS
from ...package.file_role import is_set_aside
from ...package.install_table import InstallTable
from ...package.launch.live_text import live_text
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...ros.distros import Targets
from ...ros.interfaces import KINDS
from ...ros.manifest import BUILD_TYPES, OTHER_BUILD_TYPES
from ..repository.released import Release
from .schema_tests import SchemaTests

IDLE = frozenset(
    "cmake_minimum_required project cmake_policy find_package message set unset list string option include_guard "
    "add_definitions add_compile_options add_compile_definitions ament_package enable_testing return".split()
)
"""Commands that build and install nothing; ament_package alone writes what only CMake reads."""

GENERATES = regex(r"(?i)rosidl|generate\w*_(?:interfaces|messages)|_interfaces\s*\(")
"""Commands that generate interfaces, and macros around them by their usual names."""

CODE = (".py", ".cpp", ".cc", ".c", ".hpp", ".h", ".rs", ".msg", ".srv", ".action", ".launch", "Makefile", "Cargo.toml")


@dataclass(frozen=True)
class ManifestForTargets:
    manifest: Manifest
    targets: Targets


@dataclass(frozen=True)
class NamedManifest:
    """A manifest, with who meets a name that colcon builds and others refuse."""

    package: ManifestAndFiles
    tests: SchemaTests
    release: Release

    @property
    def is_met(self) -> bool:
        """Whether rosidl, a test with the schema or a release refuses an odd name."""
        return self.package.generates_interfaces or self.tests.is_tested or self.release.is_made


@dataclass(frozen=True)
class ManifestInFolder:
    manifest: Manifest
    facts: PackageFacts


@dataclass(frozen=True)
class ManifestAndFiles:
    manifest: Manifest
    files: PackageFiles
    targets: Targets
    settings: RuleSettings

    @cached_property
    def interface_files(self) -> tuple[str, ...]:
        """The .msg, .srv and .action files in the folders of those names."""
        return tuple(
            path
            for kind in KINDS
            for path in self.files.below(kind)
            if path.endswith("." + kind) and path.count("/") == 1
        )

    @cached_property
    def generates_interfaces(self) -> bool:
        """Whether it has interface files, and its CMake files speak of a command that generates them."""
        built = (path for path in self.files.paths if path.endswith(("CMakeLists.txt", ".cmake")))
        return bool(self.interface_files) and any(GENERATES.search(live_text(self.files, path)) for path in built)

    @property
    def is_set_aside(self) -> bool:
        """Whether the package lies in a folder for what nobody uses any more."""
        return is_set_aside(f"{self.files.folder}/")

    @property
    def known_build_types(self) -> frozenset[str]:
        return self.settings.build_types.union(BUILD_TYPES, OTHER_BUILD_TYPES)


@dataclass(frozen=True)
class ManifestAndInstalls:
    manifest: Manifest
    files: PackageFiles
    table: InstallTable | None
    targets: Targets

    def is_installed(self, path: str) -> bool | None:
        """Return whether a file is installed in share/<name> at this path; None where that is unknown."""
        if self.table is None or not self.table.knows("share"):
            return None
        return any(path == below for below, _ in self.table.below(f"share/{self.manifest.name}"))


@dataclass(frozen=True)
class ManifestAndCMake:
    """Made only where the CMake files of the package, if it has some, can be read."""

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
        """Return whether the configuration certainly fails without a part of ament_cmake, as DEP104 tells."""
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
        """Whether it is ROS 1's: it depends on catkin and on nothing of ament."""
        names = {each.name for each in self.manifest.dependencies} | self.found
        return "catkin" in names and not any(name.startswith("ament_") for name in names)

    @property
    def is_left_to_ros1(self) -> bool:
        """Whether CMake makes a package of ROS 1 of it, under a condition, and none of ROS 2 under any."""
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
        """Whether it marks a folder of files for other tools, as Drake's PackageMap: nothing in it is built or run."""
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
        """Whether a package is found that may provide ament_package under another name."""
        return any(name.endswith("_cmake") for name in self.found)
