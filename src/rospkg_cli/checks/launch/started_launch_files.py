"""Rule input: whether anything for ROS 2 starts or includes a launch file, by its package and its name."""

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
from ..repository.pages_and_scripts import pages_and_scripts

CODE = (".py", ".xml", ".launch", ".yaml", ".yml", ".cpp", ".cc", ".hpp", ".h")
COMMAND = "ros2 launch"
"""What starts a launch file in ROS 2."""


@dataclass(frozen=True)
class StartedLaunchFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, file: LaunchFile, leftovers: frozenset[str]) -> bool:
        """Return whether a command of a page or a script, code, or a launch file for ROS 2 names a launch file.

        Files of some paths do not count: those for ROS 1. A launch file here need not name its own package.
        """
        name = posixpath.basename(file.path)
        named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?!\.?\w)")
        own = re.compile(rf"(?<![\w-]){re.escape(self.package.name)}(?![\w-])")
        texts = ((path, text) for path, text in self.code if path != file.path and path not in leftovers)
        if any(named.search(text) and (role_of(path) == "launch" or own.search(text)) for path, text in texts):
            return True
        typed = re.compile(rf"{COMMAND} +(?:[\w.~/-]*/)?{re.escape(name)}(?!\.?\w)")
        if any(typed.search(line) or (named.search(line) and own.search(line)) for line in self.commands):
            return True
        return self.is_included_elsewhere(name)

    def is_included_elsewhere(self, name: str) -> bool:
        """Return whether another package includes a launch file of a name that this package alone has."""
        others = [each for each in self.workspace.packages if each.name != self.package.name]
        if not any(name in each.includes for facts in others for each in facts.launch_summaries):
            return False
        return not any(posixpath.basename(path) == name for facts in others for path in facts.share_files)

    @cached_property
    def commands(self) -> tuple[str, ...]:
        """The lines of pages and scripts that start something in ROS 2."""
        lines = (line for text in pages_and_scripts(self.files) for line in text.splitlines())
        return tuple(line for line in lines if COMMAND in line)

    @cached_property
    def code(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each file that may start or include others."""
        paths = (path for path in self.files.paths if path.endswith(CODE) and path != "package.xml")
        paths = (path for path in paths if role_of(path) != "aside" and self.files.holds(path, b".launch"))
        return tuple((path, live_text(self.files, path)) for path in paths)
