"""Rule input: a file that can't be read, with who opens it."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ..files import PackageFiles
from ..languages.cmake.lexer import tokens
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.behavior_trees import is_tree
from ..package.file_role import role_of
from ..read_problem import ReadProblem
from ..unreadable import Unreadable
from .fault import Level
from .led_to import YAML, LedTo
from .opening_places import OpeningPlaces
from .repository.started_texts import StartedTexts
from .urdf.met_robots import MetRobots
from .urdf.opened_robots import XACRO, OpenedRobots

TAKEN_BY_URDFDOM = frozenset({ReadProblem.XML_PREFIX, ReadProblem.XML_AFTER_ROOT})
"""What tinyxml2, which knows no prefixes and takes several root elements, reads all the same."""

COMMENTS = ("comment", "bracket comment")
ROS1_LAUNCH = regex(r"<node\b[^>]*\btype\s*=|\$\(find ")
"""Nodes and paths as roslaunch takes them."""
LIBRARY = regex(r"\A\s*(?:<\?[^>]*\?>\s*|<!--.*?-->\s*)*<library\b", re.DOTALL)
"""A plugin description without a root element: pluginlib reads each `<library>` after the other."""
HOLE = regex(r"\?{3}|<(?:[A-Z]{2,}[A-Z_ ]*|(?:your|insert|fill)[\w -]+)>")
"""What stands in code for what whoever takes an exercise on has to write."""
LOST = regex("[\udc80-\udcff]")
"""What `surrogateescape` makes of bytes that are no text."""


@dataclass(frozen=True)
class UnreadableFile:
    file: Unreadable
    opened: OpenedRobots
    met: MetRobots
    opening: OpeningPlaces
    files: PackageFiles

    @property
    def is_in_comments(self) -> bool:
        """Whether it is a file of CMake whose bytes that are no text stand in comments alone."""
        if not self.file.path.endswith(("CMakeLists.txt", ".cmake")):
            return False
        text = self.files.tree.entry(self.file.path).data.decode("utf-8", "surrogateescape")
        return not any(LOST.search(token.text) for token in tokens(text) if token.kind not in COMMENTS)

    @property
    def is_left_alone(self) -> bool:
        """Whether it is a launch file or YAML that nothing leads to."""
        path = self.file.path
        is_asked = role_of(path) == "launch" or path.endswith(YAML)
        return is_asked and not LedTo(self.opening).has(path)

    @cached_property
    def started(self) -> StartedTexts:
        return StartedTexts(self.files)

    @property
    def is_loose_module(self) -> bool:
        """Whether it is a module or a program that nothing starts, as far as the texts of the package say.

        setuptools prints the error as it compiles the module, and goes on: nothing fails until something imports it.
        """
        path = self.file.path
        is_module = role_of(path) == "run" and path != "setup.py" and not path.endswith("__init__.py")
        return self.file.code is ReadProblem.PYTHON_SYNTAX and is_module and not self.started.is_reached(path)

    @property
    def has_blank(self) -> bool:
        """Whether the line of Python that can't be read has a hole in it, as in exercises: `create_timer(???)`."""
        if self.file.code is not ReadProblem.PYTHON_SYNTAX:
            return False
        text, at = self.files.readable_text(self.file.path), self.file.span.start
        return HOLE.search(text[text.rfind("\n", 0, at) + 1 :].partition("\n")[0]) is not None

    def level_of_module(self) -> tuple[Level | None, str]:
        """Return the level of a module that nothing here starts, and why: another package may import it."""
        path = self.file.path
        module = posixpath.splitext(path)[0].replace("/", ".")
        wanted, others = {(module, ""), tuple(module.rpartition(".")[::2])}, self.opened.workspace.packages
        taken = (each.taken_names for each in others if each.name != self.opened.package.name)
        if any(name == module or (name, what) in wanted for names in taken for name, what in names):
            return "warning", "; nothing that is started here imports this module, another package does"
        is_named = self.started.is_named(path)
        return "info", f"; {'nothing that is started imports' if is_named else 'no other file names'} this module"

    def level_of_robot(self) -> tuple[Level | None, str]:
        """Return the level of a robot, a world or a behavior tree, by who opens it."""
        path = self.file.path
        if not self.files.readable_text(path).strip() and not self.opened.texts.are_naming_in_full(path):
            return "info", "; no file of the package names it"
        is_met = path.endswith(XACRO) and self.met.has(path)
        if is_met or any(map(self.opening.has, (path, *self.opened.including(path)))):
            return None, ""
        if self.opened.has(path):
            return "info", "; no text that is read here names it with its place"
        return "info", "; no file of the package opens it"

    def level(self) -> tuple[Level | None, str]:
        """Return the level, None for the rule's own, and why it is another: a robot may be read, or by nothing."""
        path = self.file.path
        if path.endswith(".urdf") and self.file.code in TAKEN_BY_URDFDOM:
            level, why = self.level_of_robot()
            return (level, why) if level else ("warning", "; xacro and Python stop there, urdfdom reads past it")
        if self.file.code is ReadProblem.XML_AFTER_ROOT and LIBRARY.match(self.files.readable_text(path)):
            return "info", "; pluginlib reads past it, other readers stop there: put `<class_libraries>` around all"
        if path.endswith((".urdf", ".xacro", ".sdf", ".world")) or is_tree(self.files, path):
            return self.level_of_robot()
        if self.file.code is ReadProblem.ENCODING and self.is_in_comments:
            return "info", "; CMake reads past these bytes, since only comments hold them"
        if self.has_blank:
            return "info", "; the line has a blank that is to be filled in"
        if self.is_left_alone:
            return "info", "; no other file names it"
        if path.endswith(".launch") and ROS1_LAUNCH.search(self.files.readable_text(path)):
            is_for_both = self.files.holds("package.xml", b"catkin")
            return "warning" if is_for_both else "info", "; it is written for ROS 1"
        return self.level_of_module() if self.is_loose_module else (None, "")
