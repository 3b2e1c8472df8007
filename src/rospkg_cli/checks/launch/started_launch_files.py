"""Rule input: whether anything but launch files for ROS 1 starts or includes a launch file, by its name."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..pages_and_scripts import pages_and_scripts

CODE = (".py", ".xml", ".launch", ".yaml", ".yml", ".cpp", ".cc", ".hpp", ".h")
OF_ROS1 = "roslaunch"
"""What starts a launch file in ROS 1."""


@dataclass(frozen=True)
class StartedLaunchFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, file: LaunchFile, leftovers: frozenset[str]) -> bool:
        """Return whether a page, a script, code or a launch file that is not one of some names a launch file."""
        name = posixpath.basename(file.path)
        named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?!\.?\w)")
        texts = (text for path, text in self.code if path != file.path and path not in leftovers)
        if any(named.search(text) for text in texts) or any(named.search(line) for line in self.lines):
            return True
        others = (each for each in self.workspace.packages if each.name != self.package.name)
        return any(name in each.includes for facts in others for each in facts.launch_summaries)

    @cached_property
    def lines(self) -> tuple[str, ...]:
        """The lines of pages and scripts, but for those that are for ROS 1."""
        lines = (line for text in pages_and_scripts(self.files) for line in text.splitlines())
        return tuple(line for line in lines if ".launch" in line and OF_ROS1 not in line)

    @cached_property
    def code(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each file that may start or include others."""
        paths = (path for path in self.files.paths if path.endswith(CODE) and path != "package.xml")
        paths = (path for path in paths if role_of(path) != "aside" and self.files.holds(path, b".launch"))
        return tuple((path, live_text(self.files, path)) for path in paths)
