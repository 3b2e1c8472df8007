"""Rule input: the texts of a package that may open a robot, and which of them name a robot's file."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import may_be_made, words_of
from ...package.workspace import Workspace
from .opening_texts import LAUNCH, ROBOTS, opening_texts

ENDS = r"(?!\.(?:xacro|urdf)\b)"
"""What follows the name of a file is no further suffix: `arm.urdf` is not named by `arm.urdf.xacro`."""
PAGES = (".md", ".rst", ".txt")
LETTERS = regex(r"[^\W\d_]{2}")
COMMAND = r"(?:\b(?:ros2|xacro\w*|check_urdf|urdf_to_\w+|rviz2?|gz|gazebo|ign|python3?)[\s(]|:=)"
"""What is in a line of a page that shows how to open a robot; other lines only mention the file."""
LOOKS = "MoveItConfigsBuilder"
"""MoveIt looks for the robot by its name alone."""


@dataclass(frozen=True)
class RobotTexts:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    @cached_property
    def every(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each file that may open a robot."""
        return tuple(opening_texts(self.files, self.package, self.workspace))

    @cached_property
    def launch_words(self) -> tuple[frozenset[str], ...]:
        """The words of each launch file."""
        return tuple(words_of(text) for path, text in self.every if path.endswith(LAUNCH))

    def may_compose(self, path: str) -> bool:
        """Return whether a launch file may compose the name of a robot's file when it runs."""
        return any(may_be_made(path.rpartition("/")[2], words) for words in self.launch_words)

    def are_naming_in_full(self, path: str) -> bool:
        """Return whether a text names a file with its suffix, and the package has no second file of this name."""
        name = re.compile(rf"{re.escape(path.rpartition('/')[2])}(?![\w.])")
        return not self.is_copy(path) and any(name.search(text) for other, text in self.every if other != path)

    def are_naming(self, path: str) -> bool:
        return any(True for _ in self.naming(path))

    def naming(self, path: str) -> Iterator[str]:
        """Yield the paths of the texts that name a file."""
        name = path.rpartition("/")[2]
        word, full, is_copy = re.escape(name.partition(".")[0]), f"{re.escape(name)}{ENDS}", self.is_copy(path)
        before = r"(?<![\w./-])" if is_copy else ""  # the other copy is named with its folder before it
        ends = rf"(?:[\"']|\.{self.no_other_suffix(name)})"  # a word before a slash is a folder
        stem = re.compile(rf"[\"'{'' if is_copy else '/'}]{word}{ends}|{before}{full}")
        plain = re.compile(rf"{before}(?<![\w.-]){word}(?![\w-])|{before}{full}")
        typed = re.compile(rf"^(?=.*{COMMAND}).*{before}{full}", re.MULTILINE)
        deeper, first = self.deeper(path), name.partition(".")[0]
        for other, text in self.every:
            if first not in text or other == path:
                continue
            how = plain if other.endswith((".yaml", ".yml")) else typed if other.endswith(PAGES) else stem
            in_full = other.endswith(ROBOTS) or not LETTERS.search(word) or not may_add_suffix(other, text, name)
            how = re.compile(before + full) if in_full else how
            may_name_it = not is_copy or "/" not in other or not other.endswith(PAGES)
            may_name_it = may_name_it and not any(has_folders(each, text) for each in deeper)
            if may_name_it and how.search(text):
                yield other

    def is_copy(self, path: str) -> bool:
        """Return whether a file at the top of the package has the name of another one in a folder below."""
        return bool(self.deeper(path))

    def deeper(self, path: str) -> list[str]:
        """Return the folders that hold a file with the name of one at the top of the package."""
        return [posixpath.dirname(each) for each in self.files.paths if "/" not in path and each.endswith(f"/{path}")]

    def no_other_suffix(self, name: str) -> str:
        """Return a pattern that excludes the suffixes of files with the same stem: `sdf`, if there is an `arm.sdf`."""
        stem = name.partition(".")[0]
        others = {each.rpartition("/")[2] for each in self.files.paths} - {name}
        ends = sorted(each.partition(".")[2] for each in others if each.partition(".")[0] == stem)
        return rf"(?!(?:{'|'.join(map(re.escape, ends))})(?![\w.]))" if ends else ""


def may_add_suffix(path: str, text: str, name: str) -> bool:
    """Return whether code may append a suffix to the stem of a robot's file; the stem may be a name in Gazebo too."""
    return not path.endswith(".py") or LOOKS in text or may_be_made(name, words_of(text))


def has_folders(folder: str, text: str) -> bool:
    """Return whether a text has the names of all folders of a path, joined or one by one, none of them as a suffix."""
    return all(re.search(rf"(?<![\w.]){re.escape(each)}(?![\w.])", text) for each in folder.split("/"))
