"""The packages whose files robots and worlds name: `package://…` and `$(find …)`."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...light_dataclasses import dataclass
from ...package.urdf.robot_file import ResourceReference, RobotFile
from ...source import Span
from ..urdf.xacro_calls import XacroCalls
from .declared_dependencies import DeclaredDependencies
from .files_in_use import FilesInUse
from .robot_use import RobotUse, unopened

if TYPE_CHECKING:
    from ..urdf.ways_into_robots import WaysIntoRobots

OF_GAZEBO = (".sdf", ".world")
UNFILLED = "; Gazebo takes `$(find …)` as it stands, where no xacro is run on it"
SWITCHED_OFF = "; xacro reaches it only where an argument asks for it"


@dataclass(frozen=True)
class RobotReferences:
    used: FilesInUse
    calls: XacroCalls

    @property
    def declared(self) -> DeclaredDependencies:
        return self.used.launch.declared

    def undeclared(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield each undeclared package whose files an installed robot or world names, with the place."""
        for robot in self.used.robots:
            for each in robot.references if self.used.is_used(robot.path) else ():
                if not self.declared.has([each.package]):
                    is_off = self.is_off(robot.path) or self.is_switched_off(robot, each.span)
                    why = SWITCHED_OFF if is_off else self.why_unmet(robot, each.span)
                    use = reference_use(robot, each, why)
                    yield each.package, use if self.used.opened.has(robot.path) else unopened(use)

    def is_off(self, path: str) -> bool:
        """Return whether robots of the package include a file, and each of them only with an argument that is off."""
        found: list[bool] = []
        for robot in self.used.robots:
            named = (each for each in robot.references if each.use == "include")
            own = [(each.path, each.span) for each in named if each.package == self.declared.facts.name]
            own += [(each.path, each.span) for each in robot.includes]
            places = [span for included, span in own if included == path]
            found += [self.is_switched_off(robot, each) or self.why_unmet(robot, each) != "" for each in places]
        return bool(found) and all(found)

    def is_switched_off(self, robot: RobotFile, place: Span) -> bool:
        """Return whether a place is in a condition that is off by the defaults of its file, or in a macro that nothing
        calls.
        """
        from .switched_off_robots import RobotDefaults  # most robots use declared packages

        defaults = RobotDefaults(robot.document.root)
        is_uncalled = any(not self.calls.is_called(each) for each in defaults.macros_around(place))
        return is_uncalled or defaults.leaves_out(place)

    def why_unmet(self, robot: RobotFile, place: Span) -> str:
        """Return why xacro reaches a place for no robot of the package, as the end of a message; "" where it may."""
        return self.ways.why_unmet(robot.path, robot.document.root, place)

    @cached_property
    def ways(self) -> WaysIntoRobots:
        """The ways by which xacro reaches parts of robots; imported only where they use what is not declared."""
        from ..urdf.off_conditions import OffConditions
        from ..urdf.reached_files import ReachedFiles
        from ..urdf.ways_into_robots import WaysIntoRobots

        files, package, workspace = self.used.files, self.declared.facts, self.declared.workspace
        off = OffConditions(files, package, workspace)
        return WaysIntoRobots(ReachedFiles(files, package, workspace, self.calls, off), self.used.opened)


def reference_use(robot: RobotFile, reference: ResourceReference, why: str) -> RobotUse:
    """Return the use of a file; `why` says why xacro never reaches it, and is "" where it may.

    xacro replaces `$(find …)` anywhere in a file; `package://…` is for programs that show the robot.
    """
    is_filled_in = reference.use == "include" or robot.source.text.startswith("$(find", reference.span.start)
    if is_filled_in and robot.path.endswith(OF_GAZEBO) and "xacro" not in robot.source.text:
        return RobotUse(robot.path, reference.span, "and its files are used here", "it is not found", True, UNFILLED)
    consequence = "xacro stops" if is_filled_in else "it is missing wherever this is shown"
    return RobotUse(robot.path, reference.span, "and its files are used here", consequence, bool(why), why)
