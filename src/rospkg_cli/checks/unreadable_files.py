"""Rule input: a file that can't be read, with who opens it."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..unreadable import Unreadable
from .fault import Level
from .urdf.opened_robots import OpenedRobots

TAKEN_BY_URDFDOM = frozenset({ReadProblem.XML_PREFIX, ReadProblem.XML_AFTER_ROOT})
"""What tinyxml2, which knows no prefixes and takes several root elements, reads all the same."""


@dataclass(frozen=True)
class UnreadableFile:
    file: Unreadable
    opened: OpenedRobots

    def level(self) -> tuple[Level | None, str]:
        """Return the level, None for the rule's own, and why it is another: a robot may be read, or by nothing."""
        path = self.file.path
        if path.endswith(".urdf") and self.file.code in TAKEN_BY_URDFDOM:
            return "warning", "; xacro and Python stop there, urdfdom reads past it"
        if path.endswith((".urdf", ".xacro")) and not self.opened.has(path):
            return "warning", "; no file of the package opens it"
        return None, ""
