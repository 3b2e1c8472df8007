"""Rule input: a file that can't be read, with who opens it."""

from __future__ import annotations

import re

from ..files import PackageFiles
from ..languages.cmake.lexer import tokens
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.file_role import is_set_aside, role_of
from ..read_problem import ReadProblem
from ..unreadable import Unreadable
from .fault import Level
from .urdf.opened_robots import OpenedRobots

TAKEN_BY_URDFDOM = frozenset({ReadProblem.XML_PREFIX, ReadProblem.XML_AFTER_ROOT})
"""What tinyxml2, which knows no prefixes and takes several root elements, reads all the same."""

COMMENTS = ("comment", "bracket comment")
PROGRAM = regex(r"__main__|\A#!|^(?:async )?def main\b", re.MULTILINE)
SNIPPET = regex(r"\A(?:[ \t]*(?:#[^\n]*)?\n)*[ \t]+[^\s#]")
"""A text whose first line of code is indented: it is there to be pasted."""
ROS1_LAUNCH = regex(r"<node\b[^>]*\btype\s*=|\$\(find ")
"""Nodes and paths as roslaunch takes them."""
LIBRARY = regex(r"\A\s*(?:<\?[^>]*\?>\s*|<!--.*?-->\s*)*<library\b", re.DOTALL)
"""A plugin description without a root of its own: pluginlib asks each `<library>` for the next one beside it."""
NAMING = (".py", ".cfg", ".toml", ".txt", ".cmake", ".xml", ".launch", ".yaml", ".yml", ".json", ".sh")
"""Files that may name a module, beside those whose texts only tell of it."""
LOST = regex("[\udc80-\udcff]")
"""What `surrogateescape` makes of bytes that are no text."""


@dataclass(frozen=True)
class UnreadableFile:
    file: Unreadable
    opened: OpenedRobots
    files: PackageFiles

    @property
    def is_in_comments(self) -> bool:
        """Whether it is a file of CMake whose bytes that are no text stand in comments alone."""
        if not self.file.path.endswith(("CMakeLists.txt", ".cmake")):
            return False
        text = self.files.tree.entry(self.file.path).data.decode("utf-8", "surrogateescape")
        return not any(LOST.search(token.text) for token in tokens(text) if token.kind not in COMMENTS)

    @property
    def is_unused_module(self) -> bool:
        """Whether it is a module beside others of a Python package that no other file names, and no program.

        setuptools prints the error as it compiles the module, and goes on: nothing fails until something imports it.
        """
        folder, _, name = self.file.path.rpartition("/")
        stem = name.partition(".")[0]
        if self.file.code is not ReadProblem.PYTHON_SYNTAX or not self.files.exists("setup.py") or stem == "__init__":
            return False
        is_module = self.files.exists(f"{folder}/__init__.py") and role_of(self.file.path) == "run"
        if not is_module or PROGRAM.search(self.files.readable_text(self.file.path)):
            return False
        named = re.compile(rf"(?<![\w.-]){re.escape(stem)}(?!\w)|\.{re.escape(stem)}\b")
        others = (path for path in self.files.paths if path.endswith(NAMING) and path != self.file.path)
        return not any(named.search(self.files.readable_text(path)) for path in others)

    def level(self) -> tuple[Level | None, str]:
        """Return the level, None for the rule's own, and why it is another: a robot may be read, or by nothing."""
        path = self.file.path
        if path.endswith(".urdf") and self.file.code in TAKEN_BY_URDFDOM:
            return "warning", "; xacro and Python stop there, urdfdom reads past it"
        if self.file.code is ReadProblem.XML_AFTER_ROOT and LIBRARY.match(self.files.readable_text(path)):
            return "warning", "; pluginlib reads past it, other readers stop there: put `<class_libraries>` around all"
        if path.endswith((".urdf", ".xacro", ".sdf", ".world")) and not self.opened.has(path):
            return "warning", "; no file of the package opens it"
        if self.file.code is ReadProblem.ENCODING and self.is_in_comments:
            return "info", "; CMake reads past these bytes, since only comments hold them"
        if path.endswith(".launch") and ROS1_LAUNCH.search(self.files.readable_text(path)):
            return "warning", "; it is written for ROS 1"
        if self.is_unused_module:
            is_aside = is_set_aside(path) or SNIPPET.match(self.files.readable_text(path))
            return "info" if is_aside else "warning", "; no other file names this module"
        return None, ""
