"""The launch arguments that people are told to give: by each command of a page, a script or a comment."""

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
from .unset_configurations import LaunchConfigurations

COMMAND = regex(r"\b(?:ros2[ \t]+launch|roslaunch)[ \t](?:[^\n\\]|\\\n?)*")
"""A command that starts a launch file, with the lines that it goes on in."""
PACKAGE = regex(r"(?:ros2[ \t]+launch|roslaunch)[ \t]+([A-Za-z]\w*)[ \t]")
ENDINGS = (".py", ".xml", ".yaml", ".yml")
TOLD = "as each command does that pages and comments tell"


@dataclass(frozen=True)
class ConfigurationsAndPages:
    """Rule input: the launch configurations of a file, and what tells people how to start it."""

    configurations: LaunchConfigurations
    files: PackageFiles
    package: PackageFacts

    def is_told(self, name: str) -> bool:
        """Return whether commands are told that start the file, and all of them give an argument."""
        given = re.compile(rf"(?<![\w-]){re.escape(name)}:=")
        return bool(self.commands) and all(map(given.search, self.commands))

    @cached_property
    def commands(self) -> tuple[str, ...]:
        """The commands that start the file; one of ROS 1 in its own comments tells of the file before it was ported."""
        name = posixpath.basename(self.configurations.file.path)
        stem = next((name.removesuffix(each) for each in ENDINGS if name.endswith(each)), name)
        named = re.compile(rf"(?<![\w.-])(?:{re.escape(name)}|{re.escape(stem)})(?![\w-]|\.\w)")
        return tuple(each for each in self.told() if named.search(each) and not self.is_of_another(each))

    def is_of_another(self, command: str) -> bool:
        """Return whether a command starts a file of another package; own comments may have its former name."""
        found = PACKAGE.match(command)
        is_own = command in self.configurations.file.source.text
        return found is not None and not is_own and found[1] != self.package.name

    def told(self) -> Iterator[str]:
        for text in (self.configurations.file.source.text, *pages_and_scripts(self.files)):
            yield from (each.group() for each in COMMAND.finditer(text))
