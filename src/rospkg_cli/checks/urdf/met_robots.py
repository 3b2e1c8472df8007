"""Rule input: whether something of the workspace is shown to open a robot description, so that its faults are met."""

from __future__ import annotations

import re
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ..pages_and_scripts import own_pages, pages_above
from .launched_robots import LaunchedRobots
from .opened_robots import COMMAND, ENDS, OpenedRobots

TYPED = regex(COMMAND)
CODE = (".py", ".cpp", ".cc", ".hpp", ".h")
OPENS = regex(r"(?i)robot_description|spawn|xacro|urdf\w*\(|init_?(?:file|string)\(|\bopen\(|parse")
"""What code does with a robot that it names: it gives it to others, or reads it."""


@dataclass(frozen=True)
class MetRobots:
    opened: OpenedRobots
    launched: LaunchedRobots

    def has(self, path: str) -> bool:
        """Return whether a launch file, code or a command of a page opens a file, or a robot that includes it.

        What merely may open it, as a name that is put together, does not show that somebody meets its faults.
        """
        if path not in self._found:
            every = (path, *self.opened.including(path))
            self._found[path] = self.launched.has(path) or any(map(self.is_opened, every))
        return self._found[path]

    @cached_property
    def _found(self) -> dict[str, bool]:
        """The answers so far: each robot is asked for at each of its faults."""
        return {}

    def is_opened(self, path: str) -> bool:
        """Return whether code of the package, or a command of a page or a script, names a file in full."""
        if self.opened.is_copy(path) or self.opened.is_other_copy(path):
            return False
        name = re.compile(rf"(?<![\w.-]){re.escape(path.rpartition('/')[2])}{ENDS}(?![\w-])")
        return any(map(name.search, (*self.code, *self.commands)))

    @cached_property
    def commands(self) -> tuple[str, ...]:
        """The lines of pages and scripts that open something of the package: its own, and those above that name it."""
        lines = [line for text in own_pages(self.opened.files) for line in text.splitlines()]
        lines += [
            line
            for text in pages_above(self.opened.files)
            for line in text.splitlines()
            if self.opened.package.name in line
        ]
        return tuple(line for line in lines if TYPED.search(line))

    @cached_property
    def code(self) -> tuple[str, ...]:
        """The code of the package that opens a robot, but for launch files."""
        texts = ((path, text) for path, text in self.opened.texts if path.endswith(CODE))
        return tuple(text for path, text in texts if role_of(path) != "launch" and OPENS.search(text))
