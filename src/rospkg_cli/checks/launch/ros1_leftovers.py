"""Launch files for ROS 1 that a package for ROS 2 installs (LCH006)."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...unreadable import READABLE
from .launch_context import LaunchContext
from .started_launch_files import StartedLaunchFiles


@dataclass(frozen=True)
class Ros1Leftovers:
    scope: LaunchContext
    started: StartedLaunchFiles
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @cached_property
    def together(self) -> tuple[LaunchFile, ...]:
        """All such files of the package that are started, or all that are not, for the first of them.

        Empty for all but the first file, with which they are reported.
        """
        if not self.scope.is_ros1_leftover:
            return ()
        files = {each.path: each for each in (self.scope.file, *self.around) if each.is_ros1}
        left = [files[path] for path in sorted(files) if replace(self.scope, file=files[path]).is_ros1_leftover]
        found = [each for each in left if self.is_met(each) == self.is_met(self.scope.file)]
        return tuple(found) if found[0].path == self.scope.file.path else ()

    def is_met(self, file: LaunchFile) -> bool:
        """Return whether a file is started in ROS 2: something that is not for ROS 1 names it."""
        return file.path in self.met

    @cached_property
    def met(self) -> frozenset[str]:
        """The files for ROS 1 that something names which is not for ROS 1."""
        old = {each.path: each for each in (self.scope.file, *self.around) if each.is_ros1}
        return frozenset(path for path, file in old.items() if self.started.has(file, frozenset(old)))
