"""Robots of one folder that lack the same file for the same cause, as several that one xacro file was made into."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.urdf.robot_file import RobotFile
from ...source import Span
from ...unreadable import READABLE
from .enclosing_elements import ancestors
from .launched_robots import LaunchedRobots
from .missing_resource import MissingResource
from .opened_robots import OpenedRobots

Place = tuple[Span, str]
"""Where a path stands, and the path."""


@dataclass(frozen=True)
class SameFolder:
    opened: OpenedRobots
    launched: LaunchedRobots
    robots: Annotated[tuple[RobotFile, ...], READABLE] = ()

    def lacking(self, robot: RobotFile, missing: MissingResource) -> Iterator[tuple[str, Span]]:
        """Yield the other robots that lack a file, with the place: of the same folder, and opened by as much."""
        place = around(robot, missing.span)
        for other in self.robots if not (missing.is_include or missing.is_model) else ():
            if other.path == robot.path or not self.are_alike(robot.path, other.path):
                continue
            for each in other.references:
                same = (each.package, each.path) == (missing.package, missing.path)
                if same and around(other, each.path_span) == place:
                    yield other.path, each.path_span
                    break

    def untold(self, robot: RobotFile, found: list[Place]) -> list[Place]:
        """Return the paths that a robot names; none where an earlier one of the folder names all of them too."""
        earlier = (each for each in self.robots if each.path < robot.path and self.are_alike(each.path, robot.path))
        return [] if any(all(path in each.source.text for _, path in found) for each in earlier) else found

    def are_alike(self, path: str, other: str) -> bool:
        is_near = posixpath.dirname(path) == posixpath.dirname(other)
        return is_near and all(each.has(path) == each.has(other) for each in (self.launched, self.opened))


def around(robot: RobotFile, place: Span) -> list[str]:
    return [each.tag for each in ancestors(robot.document.root, place)]
