"""Rule input: a launch file, with its package, the workspace, and where the build installs it."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.launch.ros1 import is_named_ros1
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...source import Span
from ...unreadable import UnreadableError
from .missing_reference import MissingReference, defaults_of, is_within


@dataclass(frozen=True)
class LaunchContext:
    file: LaunchFile
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    table: InstallTable | None
    cmake: CMake | None

    @cached_property
    def places(self) -> tuple[str, ...]:
        """Where the file itself goes, relative to the share directory."""
        rows = self.table.below(f"share/{self.package.name}") if self.table is not None else ()
        return tuple(path for path, row in rows if row.source == self.file.path)

    @property
    def is_installed(self) -> bool:
        """Whether the file itself is installed, or may be: else it is only started by its path in the source."""
        return self.table is None or not self.table.knows("share") or bool(self.places)

    @cached_property
    def is_unused_test(self) -> bool:
        """Whether it is a test that CMake, which is all known, does not run."""
        from ...package.cmake.named_files import mentions_file  # few launch files are tests

        test = role_of(self.file.path) == "test"
        is_known = self.cmake is not None and self.cmake.is_complete
        return test and is_known and self.cmake is not None and not mentions_file(self.cmake, self.file.path)

    @property
    def is_ros1_leftover(self) -> bool:
        """Whether the file is one for ROS 1 that a package for ROS 2 alone installs, by chance."""
        try:
            manifest = self.files.source("package.xml").text
        except UnreadableError:
            return False
        alone = self.package.build_type.startswith("ament") and "catkin" not in manifest.lower()
        alone = alone and not self.files.holds("CMakeLists.txt", b"catkin_package")
        return self.file.is_ros1 and not is_named_ros1(self.file.path) and bool(self.places) and alone

    @cached_property
    def overwritten_defaults(self) -> tuple[Span, ...]:
        """The defaults of the arguments that the file gives another value itself."""
        names = {text.literal for text in self.file.assigned}
        return tuple(defaults_of(each for each in self.file.arguments if each.name.literal in names))

    def is_overwritten(self, missing: MissingReference) -> bool:
        """Return whether every place that names a file is the default of an argument that gets another value."""
        return is_within(missing, self.overwritten_defaults)
