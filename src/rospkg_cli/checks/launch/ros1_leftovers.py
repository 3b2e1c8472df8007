"""Launch files for ROS 1 that a package for ROS 2 installs (LCH006)."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...unreadable import READABLE
from .missing_references import LaunchContext


@dataclass(frozen=True)
class Ros1Leftovers:
    scope: LaunchContext
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @cached_property
    def together(self) -> tuple[LaunchFile, ...]:
        """All such files of the package, for the first of them; none for the others, which are told with it."""
        if not self.scope.is_ros1_leftover:
            return ()
        files = {each.path: each for each in (self.scope.file, *self.around) if each.is_ros1}
        found = [files[path] for path in sorted(files) if replace(self.scope, file=files[path]).is_ros1_leftover]
        return tuple(found) if found[0].path == self.scope.file.path else ()
