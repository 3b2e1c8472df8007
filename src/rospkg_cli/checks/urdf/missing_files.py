"""Rule input: a robot description with the files that it refers to, in its package and in other packages."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import ResourceReference, RobotFile
from ...package.workspace import Workspace
from ...ros.share_layout import FOLDERS
from ...source import Span
from ...suggest import nearest
from ..fault import Fault, softer
from ..install_faults import InstallFaults
from ..paths.closest_path import closest_path
from ..repository.pages_and_scripts import ARCHIVES, FetchedFiles
from .bare_meshes import is_relative
from .control_readers import ControlReaders
from .emptied_folders import emptied_folders
from .given_to_gazebo import GivenToGazebo
from .launched_robots import LaunchedRobots
from .met_robots import MetRobots
from .missing_resource import MissingResource, State
from .model_files import missing_of_models
from .opened_robots import OpenedRobots
from .reached_files import ReachedFiles
from .replaced_paths import ReplacedPaths
from .same_folder import SameFolder
from .shown_robots import ShownRobots
from .xacro_calls import CONDITIONS, XacroCalls, ancestors

LOADS = regex(r"\bload_yaml\(\s*[\"']$")
REACH = 40


@dataclass(frozen=True)
class RobotInWorkspace:
    robot: RobotFile
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    install: InstallFaults
    calls: XacroCalls
    opened: OpenedRobots
    launched: LaunchedRobots
    met: MetRobots
    shown: ShownRobots
    reached: ReachedFiles
    replaced: ReplacedPaths
    fetched: FetchedFiles
    beside: SameFolder
    gazebo: GivenToGazebo
    table: InstallTable | None
    readers: ControlReaders

    @property
    def is_installed(self) -> bool:
        """Whether the robot itself is installed, or may be: else only who works in the source reads it."""
        if self.table is None or not self.table.knows("share"):
            return True
        return any(row.source == self.robot.path for row in self.table.rows)

    @property
    def is_idle(self) -> bool:
        """Whether nothing opens the robot, as far as the texts of the workspace say."""
        return not (self.launched.has(self.robot.path) or self.opened.has(self.robot.path))

    @property
    def is_met(self) -> bool:
        """Whether something of the workspace is shown to open the robot, so that somebody meets what it lacks."""
        return self.met.has(self.robot.path)

    def misses_bare(self, meshes: Collection[tuple[Span, str]]) -> bool:
        """Return whether somebody is shown to miss meshes without a scheme: Gazebo finds some paths all the same."""
        path = self.robot.path
        is_met = (self.launched if is_relative(meshes) else self.shown).has(path)
        return is_met and not self.gazebo.finds(path, (each for _, each in meshes))

    @property
    def may_be_read_as_it_is(self) -> bool:
        """Whether it is no xacro by its name, and nothing in the package opens it: others may do so without xacro."""
        return self.robot.path.endswith(".urdf") and not self.opened.is_named(self.robot.path)

    def is_fetched(self, missing: MissingResource) -> bool:
        """Return whether a page or a script tells to fetch a file that is missing; those that xacro reads are code."""
        return not missing.is_include and self.fetched.has(missing.path)

    def weighed(self, fault: Fault) -> Fault:
        """Return a fault at the level of its place; a default that nothing reads, or all replace, does no harm."""
        for around in ancestors(self.robot.document.root, fault.span):
            name = around.get("name") or ""
            if around.tag == "xacro:arg" and self.opened.is_always_given(self.robot.path, name):
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
        """Return why xacro needs no default that a place is in, or never comes there; imported for a missing file."""
        from .unread_defaults import why_unread
        from .ways_into_robots import WaysIntoRobots

        ways, path, root = WaysIntoRobots(self.reached, self.opened), self.robot.path, self.robot.document.root
        return why_unread(ways, path, root, place) or ways.why_left_out(path, root, place)

    def is_off(self, condition: Element) -> bool:
        """Return whether a condition holds for nobody: by its argument's default, or by what all launch files give."""
        off = self.reached.off
        if off.has(condition):
            return True
        is_given = self.opened.is_always_given(self.robot.path, off.argument_of(condition))
        return is_given and off.is_given_so(condition)

    def missing(self) -> Iterator[MissingResource]:
        """Yield each file, or folder, that is referenced and does not exist, once, as far as that is known."""
        found: dict[tuple[str, str, State], list[MissingResource]] = {}
        every = list(self.every_missing())
        alone = ((each.package, each.path) for each in every if not (each.is_include or each.folder or each.is_model))
        emptied = emptied_folders(((each.package, each.path or "") for each in self.robot.references), alone)
        for each in every:
            inner = posixpath.dirname(each.path)
            is_one = each.state != "absent" or (each.package, inner) in emptied
            place = each.folder or (inner if is_one else "")
            found.setdefault((each.package, place or each.path, each.state), []).append(each)
        for first, *others in found.values():
            yield replace(first, others=tuple(others))

    def every_missing(self) -> Iterator[MissingResource]:
        for reference in self.robot.references:
            facts = self.facts_of(reference)
            path = reference.path
            if facts is None or not path or path.startswith("..") or self.is_expected(facts, path):
                continue
            state = self.state(facts, path)
            meant = self.goes_to(path) if state == "elsewhere" else self.suggestion(facts, path)
            if state is not None and (facts.knows("share_files") or meant) and not self.is_told(facts, path, state):
                folder = self.missing_folder(facts, path) if state == "absent" else ""
                better = meant if not folder or meant is None else self.folder_meant(folder, path, meant)
                is_read = reference.use == "include" or self.is_loaded(reference)
                yield MissingResource(reference.path_span, facts.name, path, state, is_read, better, folder)
        for local in self.robot.includes:
            if not local.path.startswith("..") and not self.files.exists(local.path) and not self.is_made(local.path):
                near = nearest(posixpath.basename(local.path), self.neighbours(local.path))
                yield MissingResource(local.span, self.package.name, local.path, "absent", True, near)
        yield from missing_of_models(self.robot, self.files, self.workspace)

    def is_loaded(self, reference: ResourceReference) -> bool:
        """Return whether xacro reads a file for an expression, and stops without it."""
        text = self.robot.source.text
        return LOADS.search(text, max(0, reference.span.start - REACH), reference.span.start) is not None

    def is_expected(self, facts: PackageFacts, path: str) -> bool:
        """Return whether a build or a submodule may bring a file."""
        if facts is self.package:
            return facts.may_write(path) or self.is_made(path)
        return facts.may_write(path) or self.files.absent_in(facts.folder).is_ignored(path)

    def is_made(self, path: str) -> bool:
        is_there = self.files.exists(path) or path in self.files.folders
        return not is_there and self.files.absent.is_expected(path)

    def facts_of(self, reference: ResourceReference) -> PackageFacts | None:
        own = reference.package == self.package.name
        return self.package if own else self.workspace.named(reference.package)

    def state(self, facts: PackageFacts, path: str) -> State | None:
        if path in facts.share_files or path in self.share_folders(facts):
            return None
        if facts is not self.package or not (self.files.exists(path) or path in self.files.folders):
            if path in facts.uninstalled:
                return "not installed"
            return "absent" if path not in facts.run_time_files else None
        if self.goes_to(path):
            return "elsewhere" if facts.knows("share_files") else None
        top = path.partition("/")[0]
        partly = "/" not in path or top in self.share_folders(facts) or top not in FOLDERS
        return "not installed" if partly and facts.knows("share_files") else None

    def goes_to(self, path: str) -> str | None:
        """Return where a file of the package goes below the prefix."""
        return self.table.destination_of(path) if self.table is not None else None

    def is_told(self, facts: PackageFacts, path: str, state: State) -> bool:
        place = (self.goes_to(path) or "") if state == "elsewhere" else ""
        is_misplaced = bool(place) and self.install.is_reported_at_destination(facts.name, place)
        return is_misplaced or (state != "absent" and self.install.is_reported(facts.name, path))

    def share_folders(self, facts: PackageFacts) -> frozenset[str]:
        return self._own_folders if facts is self.package else folders_of(facts.share_files)

    @cached_property
    def _own_folders(self) -> frozenset[str]:
        return folders_of(self.package.share_files)

    def missing_folder(self, facts: PackageFacts, path: str) -> str:
        """Return the outermost folder of a path that a package does not have; "" where it has the whole folder."""
        known = self.share_folders(facts) | (self.files.folders if facts is self.package else frozenset())
        parts = path.split("/")
        above = ("/".join(parts[:end]) for end in range(1, len(parts)))
        return next((folder for folder in above if folder not in known), "")

    def suggestion(self, facts: PackageFacts, path: str) -> str | None:
        """Return the likely path: a near one, or the file of that name next to this robot."""
        known = set(facts.share_files) | (set(self.files.paths) if facts is self.package else set())
        known = {each for each in known if not each.endswith(ARCHIVES)}
        if near := closest_path(path, known):
            return near
        beside = posixpath.join(posixpath.dirname(self.robot.path), posixpath.basename(path))
        return beside if facts is self.package and self.files.exists(beside) else None

    @staticmethod
    def folder_meant(folder: str, path: str, meant: str) -> str:
        """Return the folder that stands for the missing one, where the rest of both paths is the same."""
        rest = path.removeprefix(folder)
        return meant.removesuffix(rest) if meant.endswith(rest) else posixpath.dirname(meant)

    def neighbours(self, path: str) -> list[str]:
        folder = posixpath.dirname(path)
        return [posixpath.basename(each) for each in self.files.paths if posixpath.dirname(each) == folder]


def folders_of(paths: frozenset[str]) -> frozenset[str]:
    found = set()
    for path in paths:
        while path := posixpath.dirname(path):
            found.add(path)
    return frozenset(found)
