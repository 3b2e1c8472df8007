"""What a package installs in its share directory, against its folders for run time."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.intended_paths import intended_paths
from ...package.file_role import role_of
from ...package.install_table import InstalledFile, InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...ros.share_layout import FOLDERS
from ...unreadable import READABLE
from ..share_uses import ShareUses
from ..started_files import is_started, launches_nothing
from .unmatched_patterns import unmatched_patterns

LAUNCH = "launch"
FEW = 2
"""Launch files that don't show what is done with a third one."""
STRAY = f"share/{LAUNCH}/"
"""Where launch files are never found, whatever else is installed."""
INSTALLERS = ("install", "ament_auto_package", "autoware_ament_auto_package")
ONE_FILE = "generate_parameter_"
"""How commands begin that make code of one file: others in its folder are for run time."""
USED_AT_BUILD = regex(r"generate_parameter_|rosidl_|protobuf_|qt\d?_|ament_add_|add_launch_test|add_test|add_ros_test")


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

    def left_out(self) -> Iterator[tuple[str, InstalledFile]]:
        """Yield the one launch file that is not installed where rules list all others of the folder, with one of them.

        What a launch file names is reported there.
        """
        files = [path for path in self.useful(LAUNCH) if posixpath.dirname(path) == LAUNCH] if self.is_clear else []
        listed = {text for rule in self.package.cmake.installs if rule.kind == "FILES" for text in rule.call.texts}
        rows = {row.source: row for row in self.table.rows if row.source in files}
        lost = [path for path in files if path not in rows]
        if len(lost) == 1 and len(files) > FEW and all(path in listed for path in rows):
            name, text_of = posixpath.basename(lost[0]), self.package.cmake.package_files.readable_text
            texts = (*map(text_of, files), *(file.source.text for file in self.launch_files))
            if not any(name in text for text in texts) and lost[0] not in self.named_paths:
                yield lost[0], next(iter(rows.values()))

    @cached_property
    def named_paths(self) -> frozenset[str]:
        calls = (call for call in self.package.cmake.calls if call.name not in INSTALLERS)
        return frozenset(path for call in calls for path in paths_of(call))

    @property
    def is_clear(self) -> bool:
        """Whether all that is installed into the share directory is known."""
        return self.is_read and self.table.knows("share")

    @property
    def is_read(self) -> bool:
        """Whether all install rules are there to be read."""
        cmake = self.package.cmake
        return cmake.is_complete and cmake.ends_a_package and not cmake.includes_unknown_files

    def misplaced_launch_file(self) -> InstalledFile | None:
        """Return the first launch file that is installed, where none is below share/ and the package's name.

        Absolute places, and those below the name that project() has by mistake, are reported by other rules.
        """
        files = self.useful(LAUNCH)
        rows = [row for row in self.table.rows if row.source in files]
        if not (self.is_clear and self.table.knows("other")):
            rows = [row for row in rows if row.destination.startswith(STRAY)]
        known = ("/", *(f"share/{name}/" for name in (self.package.facts.name, self.package.cmake.project_name)))
        if any(self.is_reported(row) for row in rows):
            return None
        unclear = (row for row in rows if row.maybe and not row.destination.startswith(STRAY))
        is_found = any(row.destination.startswith(known) for row in rows) or next(unclear, None) is not None
        return rows[0] if rows and not is_found else None

    def is_reported(self, misplaced: InstalledFile) -> bool:
        """Return whether a launch file of the package names what the same command installs, which LCH004 reports."""
        calls = [rule.call for rule in self.package.cmake.installs if rule.call.path == misplaced.path]
        spans = (call.command.span for call in calls)
        whole = next((each for each in spans if each.holds(misplaced.span)), misplaced.span)
        together = (row for row in self.table.rows if row.path == misplaced.path)
        sources = {row.source for row in together if whole.holds(row.span)}
        files = (file for file in self.launch_files if role_of(file.path) == "launch" and not file.is_ros1)
        return any(
            each.package == self.package.facts.name and each.path in sources for file in files for each in file.paths
        )

    def useful(self, folder: str) -> tuple[str, ...]:
        """Return the files of a folder that are used at run time, without those that the build uses."""
        files = self.package.cmake.package_files
        useful = [
            path
            for path in files.below(folder)
            if FOLDERS[folder].fullmatch(path.rpartition("/")[2]) or is_started(files, path)
        ]
        ignores = files.absent.is_ignored
        ros1 = {file.path for file in self.launch_files if file.is_ros1}
        useful = [path for path in useful if path not in self.built_from | ros1 and "/test/" not in path]
        return tuple(path for path in useful if not ignores(path) and not (folder == LAUNCH and self.is_none(path)))

    def is_none(self, path: str) -> bool:
        """Return whether a file among launch files is an empty placeholder, or none that launch can load."""
        files = self.package.cmake.package_files
        return not files.readable_text(path).strip() or launches_nothing(files, path)

    @cached_property
    def built_from(self) -> frozenset[str]:
        """The files that commands name which generate or test something."""
        calls = [call for call in self.package.cmake.calls if USED_AT_BUILD.match(call.name)]
        return frozenset(path for call in calls for path in paths_of(call))

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


def without_shown_files(call: EvaluatedCommand) -> EvaluatedCommand:
    """Return a call without the SOURCES of add_custom_target: editors show them, and nothing is done with them."""
    if call.name != "add_custom_target" or "SOURCES" not in call.texts:
        return call
    return replace(call, words=call.words[: call.texts.index("SOURCES")])


def paths_of(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the paths that a call's arguments may be, whatever their keywords."""
    for text in call.texts:
        if (path := path_in_package(text, call.folder)) and ("/" in path or "." in path or path in FOLDERS):
            yield path
