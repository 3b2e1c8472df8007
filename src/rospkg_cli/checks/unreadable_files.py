"""Rule input: a file that can't be read, with who opens it."""

from __future__ import annotations

from ..files import PackageFiles
from ..languages.cmake.lexer import tokens
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..unreadable import Unreadable
from .fault import Level
from .urdf.opened_robots import OpenedRobots

TAKEN_BY_URDFDOM = frozenset({ReadProblem.XML_PREFIX, ReadProblem.XML_AFTER_ROOT})
"""What tinyxml2, which knows no prefixes and takes several root elements, reads all the same."""

COMMENTS = ("comment", "bracket comment")
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

    def level(self) -> tuple[Level | None, str]:
        """Return the level, None for the rule's own, and why it is another: a robot may be read, or by nothing."""
        path = self.file.path
        if path.endswith(".urdf") and self.file.code in TAKEN_BY_URDFDOM:
            return "warning", "; xacro and Python stop there, urdfdom reads past it"
        if path.endswith((".urdf", ".xacro")) and not self.opened.has(path):
            return "warning", "; no file of the package opens it"
        if self.file.code is ReadProblem.ENCODING and self.is_in_comments:
            return "info", "; CMake reads past these bytes, since only comments hold them"
        return None, ""
