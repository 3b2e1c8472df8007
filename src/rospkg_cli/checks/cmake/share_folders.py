"""What a package installs in its share directory, against its folders for run time."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.intended_paths import intended_paths
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...ros.share_layout import FOLDERS
from ...unreadable import READABLE
from ..share_uses import ShareUses
from .named_paths import INSTALLERS, ONE_FILE, paths_of, without_shown_files
from .runtime_files import RuntimeFiles
from .unmatched_patterns import unmatched_patterns


@dataclass(frozen=True)
class RuntimeFolders:
    package: CMakePackage
    table: InstallTable
    workspace: Workspace
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def uninstalled(self) -> Iterator[str]:
        """Yield the folders for run time of which nothing is installed, and where install rules are known."""
        for folder in FOLDERS if self.is_read else ():
            is_known = self.table.knows_folder("share", f"share/{self.package.cmake.project_name}/{folder}")
            if not is_known or self.is_installed(folder) or self.is_named(folder) or not self.useful(folder):
                continue
            unmatched = (each.folder for each in unmatched_patterns(self.package.cmake))  # CMK129 reports the pattern
            is_reported = any(f"{each}/".startswith(f"{folder}/") for each in unmatched)
            if not is_reported and folder not in intended_paths(self.package.cmake):  # which CMK102 reports
                yield folder

    @property
    def is_clear(self) -> bool:
        """Whether all that is installed into the share directory is known."""
        return self.is_read and self.table.knows("share")

    @property
    def is_read(self) -> bool:
        """Whether all install rules are there to be read."""
        cmake = self.package.cmake
        return cmake.is_complete and cmake.ends_a_package and not cmake.includes_unknown_files

    def useful(self, folder: str) -> tuple[str, ...]:
        """Return the files of a folder that are used at run time, without those that the build uses."""
        return self.files.of(folder)

    @cached_property
    def files(self) -> RuntimeFiles:
        return RuntimeFiles(self.package.cmake, self.launch_files)

    def is_installed(self, folder: str) -> bool:
        return any(row.source.startswith(f"{folder}/") for row in self.table.rows)

    def is_named(self, folder: str) -> bool:
        """Return whether another command names the folder: then it serves another purpose."""
        return folder in self.named

    @cached_property
    def named(self) -> frozenset[str]:
        """The first folder of each path that a command names which installs nothing, and makes no code of that file
        alone."""
        calls = (call for call in self.package.cmake.calls if not call.name.startswith((*INSTALLERS, ONE_FILE)))
        return frozenset(path.partition("/")[0] for call in calls for path in paths_of(without_shown_files(call)))

    @property
    def insertion_call(self) -> EvaluatedCommand | None:
        """The call to which the folder should be added: the last rule for share/, else ament_package()."""
        cmake = self.package.cmake
        share = f"share/{cmake.project_name}"
        rules = [r for r in cmake.installs if r.kind == "DIRECTORY" and (r.destination or "").startswith(share)]
        ends = [call for call in cmake.calls if call.name.endswith(("ament_package", "ament_auto_package"))]
        return rules[-1].call if rules else ends[-1] if ends else None

    @cached_property
    def uses(self) -> ShareUses:
        absent = frozenset(folder for folder in FOLDERS if folder != "launch" and not self.is_installed(folder))
        files, name = self.package.cmake.package_files, self.package.facts.name
        return ShareUses(files, name, self.workspace, absent, self.launch_files)
