"""Rule input: whether a robot is only given to Gazebo by its path, which finds meshes next to the file (URD002)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from typing import Annotated

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import LaunchText, Literal
from ...ros.program_options import CREATORS
from ...unreadable import READABLE
from ..launch.started_viewers import program_of
from .opened_robots import OpenedRobots

READS = regex(r"(?i)robot_description|robot_state_publisher|move_?it|xacro|spawn_entity|\bopen\(|read_text\(")
"""Text of a launch file that passes a robot to other nodes, or reads it: these do not know the folder of the file."""
UNKNOWN = "\0"


@dataclass(frozen=True)
class GivenToGazebo:
    opened: OpenedRobots
    files: PackageFiles
    launches: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def finds(self, path: str, meshes: Iterable[str]) -> bool:
        """Return whether Gazebo alone opens a robot, and has all meshes that this names relative to itself.

        `create -file` of ros_gz_sim hands the path on; what reads the file and hands on its text loses the place.
        """
        folder = posixpath.dirname(path)
        are_there = all(self.files.exists(posixpath.normpath(posixpath.join(folder, each))) for each in meshes)
        return are_there and self.has(path)

    def has(self, path: str) -> bool:
        """Return whether every text that names a robot is a launch file that gives its path to Gazebo alone."""
        name = path.rpartition("/")[2]
        naming = [*self.opened.texts.naming(path)]
        if not naming or self.opened.packages.has(path) or self.is_in_a_view(name):
            return False
        texts = dict(self.opened.texts.every)
        files = {each.path: each for each in self.launches}
        return all(
            each in files and not READS.search(texts[each]) and any(gives(node, name) for node in files[each].nodes)
            for each in naming
        )

    def is_in_a_view(self, name: str) -> bool:
        """Return whether a configuration of RViz names a file."""
        views = (each for each in self.files.paths if each.endswith(".rviz"))
        return any(self.files.holds(each, name.encode()) for each in views)


def gives(node: LaunchedNode, name: str) -> bool:
    """Return whether a node of a launch file creates what a file of a name describes."""
    if program_of(node) not in CREATORS:
        return False
    said = " ".join(map(said_by, node.arguments))
    return re.search(rf"(?:^|\s)--?file[\s=]\S*/{re.escape(name)}(?:\s|$)", said) is not None


def said_by(text: LaunchText) -> str:
    return "".join(part.text if isinstance(part, Literal) else UNKNOWN for part in text.parts)
