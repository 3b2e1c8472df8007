"""Launch files for ROS 1 that a package for ROS 2 installs (LCH006)."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...unreadable import READABLE
from .missing_references import LaunchContext
from .started_launch_files import StartedLaunchFiles


@dataclass(frozen=True)
class Ros1Leftovers:
    scope: LaunchContext
    started: StartedLaunchFiles
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @cached_property
    def together(self) -> tuple[LaunchFile, ...]:
        """All such files of the package that are started, or all others, for the first of them.

        None for those that are told with it.
        """
        if not self.scope.is_ros1_leftover:
            return ()
        files = {each.path: each for each in (self.scope.file, *self.around) if each.is_ros1}
        left = [files[path] for path in sorted(files) if replace(self.scope, file=files[path]).is_ros1_leftover]
        found = [each for each in left if self.is_met(each) == self.is_met(self.scope.file)]
        return tuple(found) if found[0].path == self.scope.file.path else ()

    def is_met(self, file: LaunchFile) -> bool:
        """Return whether somebody starts a file in ROS 2: something names it, or the package has none for ROS 2."""
        return not self.has_others or file.path in self.met

    @cached_property
    def met(self) -> frozenset[str]:
        """The files for ROS 1 that something names which is not for ROS 1, or one of these does."""
        old = {each.path: each for each in (self.scope.file, *self.around) if each.is_ros1}
        met, more = set[str](), set(old)
        while more:
            idle = frozenset(old) - met
            more = {path for path in idle if self.started.has(old[path], idle)}
            met |= more
        return frozenset(met)

    @cached_property
    def has_others(self) -> bool:
        """Whether the package has a launch file for ROS 2 that starts something."""
        others = (each for each in self.around if not each.is_ros1 and each.has_entry_point)
        return any(each.root.children if each.root else each.frontend == "python" for each in others)
