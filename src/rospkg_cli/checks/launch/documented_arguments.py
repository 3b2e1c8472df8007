"""The launch arguments that every documented `ros2 launch` command gives: in pages, scripts and comments."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ..repository.pages_and_scripts import pages_and_scripts
from .launch_configurations import LaunchConfigurations

COMMAND = regex(r"\b(?:ros2[ \t]+launch|roslaunch)[ \t](?:[^\n\\]|\\\n?)*")
"""A command that starts a launch file, with the lines that it goes on in."""
PACKAGE = regex(r"(?:ros2[ \t]+launch|roslaunch)[ \t]+([A-Za-z]\w*)[ \t]")
ENDINGS = (".py", ".xml", ".yaml", ".yml")
DOCUMENTED = "as it is in every command that documentation and comments show"


@dataclass(frozen=True)
class ConfigurationsAndPages:
    """Rule input: the launch configurations of a file, and the pages that show how to start it."""

    configurations: LaunchConfigurations
    files: PackageFiles
    package: PackageFacts

    def is_documented(self, name: str) -> bool:
        """Return whether documented commands start the file, and all of them give an argument."""
        given = re.compile(rf"(?<![\w-]){re.escape(name)}:=")
        return bool(self.commands) and all(map(given.search, self.commands))

    @cached_property
    def commands(self) -> tuple[str, ...]:
        """The documented commands that start the file; its own comments may still have the command of ROS 1."""
        name = posixpath.basename(self.configurations.file.path)
        stem = next((name.removesuffix(each) for each in ENDINGS if name.endswith(each)), name)
        named = re.compile(rf"(?<![\w.-])(?:{re.escape(name)}|{re.escape(stem)})(?![\w-]|\.\w)")
        return tuple(each for each in self.documented() if named.search(each) and not self.is_of_another(each))

    def is_of_another(self, command: str) -> bool:
        """Return whether a command starts a file of another package; comments may have this one's former name."""
        found = PACKAGE.match(command)
        is_own = command in self.configurations.file.source.text
        return found is not None and not is_own and found[1] != self.package.name

    def documented(self) -> Iterator[str]:
        """Yield every launch command in the file itself, and in the pages and scripts of the repository."""
        for text in (self.configurations.file.source.text, *pages_and_scripts(self.files)):
            yield from (each.group() for each in COMMAND.finditer(text))
