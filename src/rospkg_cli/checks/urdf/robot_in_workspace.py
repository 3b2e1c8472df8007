"""Rule input: a robot description, and how likely a run of ROS meets a fault in it (URD002)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ...files import PackageFiles
from ...languages.xml.parser import Element
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import RobotFile
from ...source import Span
from ..fault import Fault, softer
from ..repository.pages_and_scripts import FetchedFiles
from .bare_meshes import is_relative
from .control_readers import ControlReaders
from .enclosing_elements import CONDITIONS, ancestors
from .given_to_gazebo import GivenToGazebo
from .launched_robots import LaunchedRobots
from .met_robots import MetRobots
from .missing_files import MissingFiles
from .missing_resource import MissingResource
from .opened_robots import OpenedRobots
from .reached_files import ReachedFiles
from .replaced_paths import ReplacedPaths
from .same_folder import SameFolder
from .share_resources import ShareResources
from .shown_robots import ShownRobots
from .xacro_calls import XacroCalls


@dataclass(frozen=True)
class RobotInWorkspace:
    robot: RobotFile
    files: PackageFiles
    package: PackageFacts
    resources: ShareResources
    calls: XacroCalls
    opened: OpenedRobots
    launched: LaunchedRobots
    met: MetRobots
    shown: ShownRobots
    reached: ReachedFiles
    replaced: ReplacedPaths
    fetched: FetchedFiles
    in_folder: SameFolder
    gazebo: GivenToGazebo
    readers: ControlReaders

    def missing(self) -> Iterator[MissingResource]:
        """Yield each file, or folder, that is referenced and does not exist, once, as far as that is known."""
        return MissingFiles(self.robot, self.files, self.resources).missing()

    @property
    def is_installed(self) -> bool:
        """Whether the robot itself is installed, or may be: otherwise it is read only in the source folder."""
        table = self.resources.table
        if table is None or not table.knows("share"):
            return True
        return any(row.source == self.robot.path for row in table.rows)

    @property
    def is_idle(self) -> bool:
        """Whether nothing opens the robot, as far as the texts of the workspace say."""
        return not (self.launched.has(self.robot.path) or self.opened.has(self.robot.path))

    @property
    def is_met(self) -> bool:
        """Whether something in the workspace is known to open the robot, so that users run into its missing files."""
        return self.met.has(self.robot.path)

    def misses_bare(self, meshes: Collection[tuple[Span, str]]) -> bool:
        """Return whether a known run lacks meshes that are named without a URL scheme; Gazebo finds some of them."""
        path = self.robot.path
        is_met = (self.launched if is_relative(meshes) else self.shown).has(path)
        return is_met and not self.gazebo.finds(path, (each for _, each in meshes))

    @property
    def may_be_read_as_it_is(self) -> bool:
        """Whether its name ends in `.urdf`, and no text of the package names it: others may read it without xacro."""
        return self.robot.path.endswith(".urdf") and not self.opened.texts.are_naming(self.robot.path)

    def is_fetched(self, missing: MissingResource) -> bool:
        """Return whether a page or a script fetches a missing file; never so for files that xacro reads."""
        return not missing.is_include and self.fetched.has(missing.path)

    def weighed(self, fault: Fault) -> Fault:
        """Return a fault at the level of its place: an info in a default that nothing reads or all replace."""
        for around in ancestors(self.robot.document.root, fault.span):
            name = around.get("name") or ""
            if around.tag == "xacro:arg" and self.opened.arguments.has(self.robot.path, name):
                return softer(fault, "info", f"where no `{name}:=` is given, which each launch file here gives")
            if around.tag == "xacro:arg" and not self.reached.reads(self.robot.path, name):
                return softer(fault, "info", f"as soon as something reads `$(arg {name})`")
            if around.tag in CONDITIONS and self.is_off(around):
                return softer(fault, "info", "where the condition around it holds, which nothing here makes true")
            if around.tag in ("gazebo", "plugin") and not self.readers.are_here:
                return softer(fault, "info", "in Gazebo alone, which nothing here starts or needs")
            if around.tag in ("gazebo", "plugin"):
                return softer(fault, "warning", "in Gazebo alone")
        if self.replaced.has(self.robot.document, fault.span):
            return softer(fault, "info", "unless what opens it puts another path there, as a launch file here does")
        found = self.calls.weighed(self.robot.document.root, fault)
        if found.level != "info" and (why := self.why_unread(fault.span)):
            return replace(found, level="info", message=f"{found.message}{why}")
        if found.level != "info" and self.reached.is_never(self.robot.path):
            return softer(found, "info", "where the condition around its include holds, which nothing here makes true")
        if found.level is None and self.reached.is_off(self.robot.path):
            return softer(found, "warning", "where the condition around its include holds")
        return found

    def why_unread(self, place: Span) -> str:
        """Return why xacro never reads the default that a place is in, or never reaches the place; "" where it may."""
        # imported for missing files alone
        from .unread_defaults import why_unread
        from .ways_into_robots import WaysIntoRobots

        ways, path, root = WaysIntoRobots(self.reached, self.opened), self.robot.path, self.robot.document.root
        return why_unread(ways, path, root, place) or ways.why_left_out(path, root, place)

    def is_off(self, condition: Element) -> bool:
        """Return whether a condition never holds: by the default of its argument, or by what all launch files give."""
        off = self.reached.off
        if off.has(condition):
            return True
        is_given = self.opened.arguments.has(self.robot.path, off.argument_of(condition))
        return is_given and off.is_given_so(condition)
