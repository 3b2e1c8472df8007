"""Files of a package that are used at run time: launch files, parameters, robots, RViz configs, worlds."""

from __future__ import annotations

from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.launch.launch_file import LaunchFile
from ...ros.share_layout import FOLDERS
from ..started_files import is_started, launches_nothing
from .named_paths import paths_of

LAUNCH = "launch"
USED_AT_BUILD = regex(r"generate_parameter_|rosidl_|protobuf_|qt\d?_|ament_add_|add_launch_test|add_test|add_ros_test")


@dataclass(frozen=True)
class RuntimeFiles:
    cmake: CMake
    launch_files: tuple[LaunchFile, ...]

    def of(self, folder: str) -> tuple[str, ...]:
        """Return the files of a folder that are used at run time, without those that the build uses."""
        files = self.cmake.package_files
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
        files = self.cmake.package_files
        return not files.readable_text(path).strip() or launches_nothing(files, path)

    @cached_property
    def built_from(self) -> frozenset[str]:
        """The files that commands name which generate or test something."""
        calls = [call for call in self.cmake.calls if USED_AT_BUILD.match(call.name)]
        return frozenset(path for call in calls for path in paths_of(call))
