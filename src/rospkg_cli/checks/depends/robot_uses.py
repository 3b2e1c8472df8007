"""Undeclared packages whose files and plugins robots, RViz configs and parameter files name (DEP106)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.file_role import LAUNCH, role_of
from ...package.install_table import InstallTable
from ...package.package_facts import PluginUse
from ...package.urdf.robot_file import ResourceReference, RobotFile
from ...ros.implied_dependencies import IN_PARAMETERS, NAVIGATION, implied_by
from ...ros.names import NameKind
from ...ros.plugins import PLUGIN_PACKAGES, TOOLS
from ...source import Span
from ..launch.package_references import every_reference
from ..urdf.opened_robots import OpenedRobots
from ..urdf.xacro_calls import XacroCalls
from .brought_dependencies import brought_by
from .declared_dependencies import DeclaredDependencies
from .found_by_parameters import found_by_parameters, named_by_parameters, typed_by_parameters
from .opened_parameters import OpenedParameters
from .spawned_blocks import block_of, is_commented_out, types_beside
from .undeclared_launch_packages import LaunchDependencies

if TYPE_CHECKING:
    from ..urdf.ways_into_robots import WaysIntoRobots

INTERFACES = regex(r".*_(?:msgs|srvs|interfaces|actions)")
LOADS_PLUGINS = regex(
    r"controller_manager$|gz_ros2_control|ign_ros2_control|gazebo_ros2_control|nav2_|moveit|navigation2$|.*_bringup$"
)
"""Packages that load plugins by the names in parameter files, or whose launch files start such."""
LOADED_BY_OWN = frozenset({"laser_filters", "slam_toolbox"})
"""Packages whose plugins their own node alone loads: where that is not installed, nothing looks for them."""
LOADS_TYPES = frozenset({"joy_teleop"})
"""Packages whose nodes load interfaces by the names in their parameters."""
GENERATED = frozenset({"msg", "srv", "action"})
RUN = frozenset({"depend", "exec_depend"})
OF_GAZEBO = (".sdf", ".world")
UNFILLED = "; Gazebo takes `$(find …)` as it stands, where no xacro is run on it"
SWITCHED_OFF = "; xacro comes to it only where an argument asks for it"
UNOPENED = "; nothing here opens this file"


@dataclass(frozen=True, slots=True)
class RobotUse:
    """A place outside of code that uses a file or a plugin of another package."""

    path: str
    span: Span
    usage: str
    """What is used there, as the rest of a sentence: `and its files are used here`."""
    consequence: str
    """What happens where the package is not installed."""
    is_optional: bool = False
    """Whether the package may not be needed at all."""
    why: str = ""
    """Why nobody meets it, as the end of a sentence."""


@dataclass(frozen=True)
class RobotUses:
    declared: DeclaredDependencies
    launch: LaunchDependencies
    robots: tuple[RobotFile, ...]
    table: InstallTable | None
    opened: OpenedRobots
    calls: XacroCalls

    def missing(self) -> dict[str, list[RobotUse]]:
        """Return each package that is named and not declared, but for those that launch files use as well."""
        found: dict[str, list[RobotUse]] = {}
        if self.declared.is_checked:
            reported = self.launch.missing(tests=False)
            named = (*self.references(), *self.found_by_parameters(), *self.named(), *self.typed(), *self.plugins())
            for name, use in named:
                if name not in reported and not self.declared.has_to_run(name):
                    found.setdefault(name, []).append(use)
        return merged_navigation(found)

    def missing_in_tests(self) -> dict[str, list[RobotUse]]:
        """Return the undeclared packages of plugins in the parameter files of tests that start what loads plugins."""
        found: dict[str, list[RobotUse]] = {}
        if self.declared.is_checked and self.loads_plugins:
            reported = {*self.launch.missing(tests=False), *self.launch.missing(tests=True), *self.missing()}
            for name, use in self.plugins(tests=True):
                if name not in reported and not self.declared.has([name]):
                    found.setdefault(name, []).append(use)
        return merged_navigation(found)

    def references(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages whose files a robot or a world names, where that file is installed."""
        for robot in self.robots:
            for each in robot.references if self.is_used(robot.path) else ():
                if not self.declared.has([each.package]):
                    is_off = self.is_off(robot.path) or self.is_switched_off(robot, each.span)
                    why = SWITCHED_OFF if is_off else self.why_unmet(robot, each.span)
                    use = reference_use(robot, each, why)
                    yield each.package, use if self.opened.has(robot.path) else unopened(use)

    def found_by_parameters(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages that installed parameter files look for, where a launch file has them filled in.

        Launch does so with `allow_substs` alone; launch files in YAML are read as such.
        """
        launches = {file.path for file in self.launch.launch_files}
        for name, path, span in found_by_parameters(self.launch.files):
            is_known = self.declared.workspace.kind_of(name) is NameKind.PACKAGE
            if path not in launches and is_known and self.is_used(path):
                yield name, RobotUse(path, span, "and its files are named here", "they are not found", True)

    def named(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the unknown packages whose files installed parameter files name, and that a package here has."""
        for name, _, path, span in named_by_parameters(self.launch.files):
            if name != self.declared.facts.name and self.is_used(path) and self.renamed(name)[0]:
                use = RobotUse(path, span, "and its files are named here", "they are not found")
                yield name, use if self.parameters.may_have(path) else unopened(use)

    def typed(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages of interfaces that installed parameter files tell a node to load by their names.

        Those that come with such a node, which launch files name, are optional.
        """
        for name, interface, path, span in typed_by_parameters(self.launch.files):
            if self.declared.workspace.kind_of(name) is NameKind.PACKAGE and self.is_used(path):
                loading = LOADS_TYPES & self.started
                is_optional = not loading or not self.parameters.may_have(path)
                is_optional = is_optional or name in brought_by(sorted(loading), self.declared.workspace)
                usage = f"and its type `{interface}` is named here"
                yield name, RobotUse(path, span, usage, "the node can't load it", is_optional)

    def is_off(self, path: str) -> bool:
        """Return whether robots of the package include a file, and each only where an argument asks for it."""
        found: list[bool] = []
        for robot in self.robots:
            named = (each for each in robot.references if each.use == "include")
            own = [(each.path, each.span) for each in named if each.package == self.declared.facts.name]
            own += [(each.path, each.span) for each in robot.includes]
            places = [span for included, span in own if included == path]
            found += [self.is_switched_off(robot, each) or self.why_unmet(robot, each) != "" for each in places]
        return bool(found) and all(found)

    def is_switched_off(self, robot: RobotFile, place: Span) -> bool:
        """Return whether a place lies in a condition that the defaults of its file switch off, or in a macro that
        nothing calls.
        """
        from .switched_off_robots import RobotDefaults  # most robots use declared packages

        defaults = RobotDefaults(robot.document.root)
        is_uncalled = any(not self.calls.is_called(each) for each in defaults.macros_around(place))
        return is_uncalled or defaults.leaves_out(place)

    def why_unmet(self, robot: RobotFile, place: Span) -> str:
        """Return why no robot of the package comes to a place, as the end of a sentence; "" where one may."""
        return self.ways.why_unmet(robot.path, robot.document.root, place)

    @cached_property
    def ways(self) -> WaysIntoRobots:
        """What xacro makes of the robots; imported where they use what is not declared."""
        from ..urdf.off_conditions import OffConditions
        from ..urdf.reached_files import ReachedFiles
        from ..urdf.ways_into_robots import WaysIntoRobots

        files, package, workspace = self.launch.files, self.declared.facts, self.declared.workspace
        off = OffConditions(files, package, workspace)
        return WaysIntoRobots(ReachedFiles(files, package, workspace, self.calls, off), self.opened)

    def renamed(self, name: str) -> tuple[str, list[str]]:
        """Return who has each file that robots name in a package that is not known, and the files; "" for nobody.

        It is this package, or the only one of the workspace: the unknown name is a former one. A file that names one
        of its own path elsewhere wraps that one.
        """
        named = [(robot, each) for robot in self.robots for each in robot.references if each.package == name]
        listed = [file for package, file, *_ in named_by_parameters(self.launch.files) if package == name]
        paths = list(dict.fromkeys([*(each.path for _, each in named if each.path), *listed]))
        is_wrapped = any(robot.path == each.path for robot, each in named)
        if not paths or is_wrapped or not self.launch.is_unknown_package(name):
            return "", []
        if all(map(self.launch.files.exists, paths)):
            return self.declared.facts.name, paths
        having = [each.name for each in self.declared.workspace.packages if each.share_files.issuperset(paths)]
        return (having[0], paths) if len(having) == 1 else ("", [])

    def plugins(self, *, tests: bool = False) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages of plugins that are named by tests or by all else, but for those that come with others.

        They are optional in RViz configs and robots, which may be used without them, and in parameters of a package
        that starts nothing that loads plugins, which are for nodes of other packages.
        """
        for use in self.declared.facts.plugin_uses:
            is_meant = role_of(use.path) == "test" if tests else self.is_used(use.path)
            name = self.package_of(use) if is_meant else None
            if name is not None and name not in self.available and name not in TOOLS:
                is_optional = not use.path.endswith((".yaml", ".yml")) or not self.loads_plugins
                is_optional = is_optional or name in LOADED_BY_OWN or not self.parameters.may_have(use.path)
                is_optional = is_optional or self.is_passed_over(use) or not (use.is_listed or self.is_needed)
                usage, consequence = f"and its plugin `{use.name}` is named here", "the node can't load it"
                yield name, RobotUse(use.path, use.span, usage, consequence, is_optional)

    def is_passed_over(self, use: PluginUse) -> bool:
        """Return whether others of the same controller_manager are spawned by name, and this controller is not.

        Nor is one that a comment alone has a type for, nor any where the launch files load none.
        """
        text = self.launch.files.source(use.path).text
        if is_commented_out(text, use.span.start):
            return True
        own = block_of(text, use.span.start)
        if own is None or self.is_needed or self.parameters.is_spawned(own):
            return False
        if not self.parameters.may_spawn:
            return True
        return any(self.parameters.is_spawned(name) for name in types_beside(text, own))

    @cached_property
    def is_needed(self) -> bool:
        """Whether another package of the workspace depends on this one: it may spawn what is not spawned here."""
        return self.declared.workspace.is_needed(self.declared.facts.name)

    def package_of(self, use: PluginUse) -> str | None:
        """Return the package of a plugin; None for what may be the name of something else."""
        first, second, *_ = re.split(r"/|::", use.name)
        if elsewhere := PLUGIN_PACKAGES.get(use.name) or PLUGIN_PACKAGES.get(first):
            return elsewhere
        owner = self.declared.workspace.named(first)
        if owner is None and self.declared.workspace.kind_of(first) is NameKind.PACKAGE:
            return None if second in GENERATED or INTERFACES.fullmatch(first) else first
        if owner is not None and any(plugin.name == use.name for plugin in owner.plugins):
            return first
        return self.describing(use.name)

    def describing(self, name: str) -> str | None:
        """Return the last package of the workspace that describes a plugin of a name."""
        word = re.split(r"/|::", name)[-1]
        packages = (facts for facts in self.declared.workspace.packages if facts.may_have("plugins", (word,)))
        found = [facts.name for facts in packages if any(plugin.name == name for plugin in facts.plugins)]
        return found[-1] if found else None

    @cached_property
    def started(self) -> frozenset[str]:
        """The packages whose nodes or files the launch files use."""
        uses = (use for file in self.launch.launch_files for use in every_reference(file))
        return frozenset(use.name for use in uses if use.fails != "controller")

    @cached_property
    def parameters(self) -> OpenedParameters:
        opened = tuple(each for each in self.robots if self.is_used(each.path) and self.opened.has(each.path))
        launches = tuple(self.launch.launch_files)
        return OpenedParameters(self.declared.facts, self.declared.workspace, launches, opened, self.launch.files)

    @cached_property
    def loads_plugins(self) -> bool:
        """Whether the package starts what loads the plugins of its parameter files, or hands them to a launch file."""
        return any(LOADS_PLUGINS.match(name) for name in self.started)

    @cached_property
    def available(self) -> frozenset[str]:
        """What comes with the declared packages and those of its launch files at run time, as far as it is known.

        A node that launch files start has what its own package needs, wherever it can be started at all.
        """
        waiting, undeclared = list(self.declared.names | self.started), self.started - self.declared.names
        found = {*implied_by(waiting, IN_PARAMETERS), *brought_by(sorted(undeclared), self.declared.workspace)}
        while waiting:
            facts = self.declared.workspace.named(waiting.pop())
            new = {need.name for need in facts.dependencies if need.tag in RUN} - found if facts else set()
            found |= new | implied_by(new, IN_PARAMETERS)
            waiting += new
        return frozenset(found)

    def is_used(self, path: str) -> bool:
        """Return whether a file is installed, or may be; what lies with tests is for them alone."""
        if role_of(path) == "test":
            return False
        if self.table is None or not self.table.knows("share") or LAUNCH.search(path):
            return True
        return path in self.sources

    @cached_property
    def sources(self) -> frozenset[str]:
        return frozenset(row.source for row in self.table.rows) if self.table else frozenset()


def reference_use(robot: RobotFile, reference: ResourceReference, why: str) -> RobotUse:
    """Return the use of a file, and `why` nobody meets it; "" where somebody may.

    xacro fills in `$(find …)` wherever it stands; what shows a robot looks for `package://…`."""
    is_filled_in = reference.use == "include" or robot.source.text.startswith("$(find", reference.span.start)
    if is_filled_in and robot.path.endswith(OF_GAZEBO) and "xacro" not in robot.source.text:
        return RobotUse(robot.path, reference.span, "and its files are used here", "it is not found", True, UNFILLED)
    consequence = "xacro stops" if is_filled_in else "it is missing wherever this is shown"
    return RobotUse(robot.path, reference.span, "and its files are used here", consequence, bool(why), why)


def unopened(use: RobotUse) -> RobotUse:
    return replace(use, is_optional=True, why=UNOPENED)


def merged_navigation(found: dict[str, list[RobotUse]]) -> dict[str, list[RobotUse]]:
    """Return what is missing, with the parts of navigation2 put together where several are."""
    parts = [name for name in found if name in NAVIGATION]
    if len(parts) < 2:
        return found
    whole = [use for name in parts for use in found[name]]
    return {name: uses for name, uses in found.items() if name not in NAVIGATION} | {"navigation2": whole}
