"""Rule input: whether anything opens a robot description of a package, as far as the texts of the package say."""

from __future__ import annotations

import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace

ROBOTS = (".urdf", ".xacro", ".sdf", ".world")
OPENERS = (".py", ".xml", ".launch", ".yaml", ".yml", ".cpp", ".cc", ".hpp", ".h", ".sh", ".md", ".rst", ".txt")
LAUNCH = (".py", ".xml", ".launch", ".yaml", ".yml")
LETTERS = regex(r"[^\W\d_]{2}")
PAGES = (".md", ".rst", ".txt")


@dataclass(frozen=True)
class OpenedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, path: str) -> bool:
        """Return whether a file may be opened: a text of the package names it, or another package needs this one.

        Robots and pages name files in full; launch files and code often put the suffix behind a name, and such a name
        has letters: `1` stands everywhere.
        """
        return self.is_named(path) or self.workspace.is_needed(self.package.name)

    def is_named(self, path: str) -> bool:
        name = path.rpartition("/")[2]
        word = re.escape(name.partition(".")[0])
        stem = re.compile(rf"[\"'/]{word}[\"'./]")
        plain = re.compile(rf"(?<![\w.-]){word}(?![\w-])")
        for other, text in self.texts:
            in_full = other.endswith(ROBOTS + PAGES) or not LETTERS.search(word)
            how = None if in_full else plain if other.endswith((".yaml", ".yml")) else stem
            if other != path and (name in text or (how is not None and how.search(text))):
                return True
        return False

    def is_passed_over(self, path: str) -> bool:
        """Return whether the package opens robots, and not this one, and no other package may."""
        opens = any(".urdf" in text or ".xacro" in text for other, text in self.texts if other.endswith(LAUNCH))
        return opens and not self.has(path)

    def is_always_given(self, path: str, argument: str) -> bool:
        """Return whether each launch file that runs xacro and names a robot gives it an argument, and one does."""
        stem = re.compile(rf"\b{re.escape(path.rpartition('/')[2].partition('.')[0])}\b")
        given = re.compile(rf"\b{re.escape(argument)}:=|mappings\b[^)]{{0,500}}[\"']{re.escape(argument)}[\"']")
        names = [text for other, text in self.texts if other.endswith(LAUNCH) and "xacro" in text]
        opening = [text for text in names if stem.search(text)]
        return bool(opening) and all(map(given.search, opening))

    def read(self, path: str) -> str:
        text = self.files.readable_text(path)
        return uncommented(path, text) if path.endswith(LAUNCH) else text

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each file that may open a robot."""
        return tuple(
            (path, self.read(path))
            for path in self.files.paths
            if path.endswith(ROBOTS + OPENERS) and path != "package.xml" and role_of(path) not in ("test", "aside")
        )
