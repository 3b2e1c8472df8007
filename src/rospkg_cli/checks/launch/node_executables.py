"""What launch files start, against what packages install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Annotated

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...package.package_facts import PackageFacts
from ...ros.well_known import WrongName, removed, wrong_name
from ...source import Span
from ...suggest import nearest, slips
from ...unreadable import READABLE
from ..fault import Level
from ..paths.closest_path import is_like
from ..repository.older_distribution import OlderDistribution
from .forked_packages import is_of_fork
from .idle_actions import level_at
from .missing_references import LaunchContext
from .named_programs import named_programs
from .one_cause import CausedPlace, told_at
from .removed_arguments import is_taken_by_old_launch_alone
from .who_meets import level_met

PROGRAM = regex(r"[^.]+(\.(py|sh|bash|pl|rb|js))?")


@dataclass(frozen=True, slots=True)
class ExecutableUse:
    """A node whose package is one of the workspace and whose executable is literal."""

    path: str
    span: Span
    """Of the executable."""
    executable: str
    plain: bool
    """Whether the span holds the name and nothing else."""
    facts: PackageFacts
    level: Level | None = None
    """None for the rule's own."""
    why: str = ""
    """Of another level: part of a sentence."""
    sister: str = ""
    """Another package that installs one of this name."""
    entry: str = ""
    """The executable that is a function of the module of this name."""
    is_command: bool = False
    """Whether `ros2 run` starts it, which looks into folders of lib/<package> as well."""

    @property
    def ends(self) -> str:
        """What happens: part of a sentence."""
        if self.is_command:
            return 'the process ends with "No executable found"'
        return f"the launch stops with \"executable '{self.executable}' not found on the libexec directory\""

    @property
    def suggestion(self) -> str | None:
        """The one of its module, else the only near one, or one of other words, as a rename leaves it."""
        if self.entry:
            return self.entry
        names = self.startable
        if near := nearest(self.executable, {name for name in names if is_like(self.executable, name)}):
            return near
        words = set(self.executable.split("_"))
        renamed = [name for name in names if words <= (other := set(name.split("_"))) or other <= words]
        return renamed[0] if len(renamed) == 1 else None

    @property
    def startable(self) -> frozenset[str]:
        """The executables of the package, but for those in folders of lib/<package>, where launch doesn't look."""
        return frozenset(name for name in self.facts.executables if "/" not in name)

    @property
    def programs(self) -> list[str]:
        """Those to offer: no libraries, and no data that was installed beside the programs."""
        return sorted(filter(PROGRAM.fullmatch, self.startable))

    @property
    def in_folder(self) -> str:
        """The executable of this name in a folder of lib/<package>; "" for none."""
        name = posixpath.basename(self.executable)
        paths = sorted(each for each in self.facts.executables - self.startable if posixpath.basename(each) == name)
        return paths[0] if paths else ""


@dataclass(frozen=True, slots=True)
class WellKnownUse:
    """A node of a package that everybody uses, whose executable it does not have."""

    package: str
    executable: LaunchText
    name: str
    wrong: WrongName
    level: Level | None
    why: str
    plain: bool
    """Whether the text is the name and nothing else."""


@dataclass(frozen=True)
class NodeExecutables:
    scope: LaunchContext
    distribution: OlderDistribution
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @property
    def each_file(self) -> Iterator[NodeExecutables]:
        """Those of each launch file of the package; this one is first."""
        yield self
        for file in self.around:
            if file.path != self.scope.file.path:
                yield replace(self, scope=replace(self.scope, file=file))

    def level_of(self, use: WellKnownUse) -> Level | None:
        """Return the level of a name that is not there; one of an older distribution is met in a newer one alone.

        In a fork it may be kept.
        """
        is_older = self.distribution.is_for_unsupported(self.scope.file.path) or not self.distribution.is_newer_shown
        is_older = is_older or self.uses_plugins_of(use.package)
        is_kept = is_older or is_of_fork(use.package, self.scope.package, self.scope.workspace)
        if use.wrong.is_removed and is_kept:
            return "info"
        return use.level or ("warning" if use.wrong.is_removed or "/" in use.wrong.better else None)

    def uses_plugins_of(self, package: str) -> bool:
        """Return whether parameters or descriptions here name plugins that a package had in that old distribution.

        That is none where a page names a supported one: then all of it is left over.
        """
        facts = self.scope.package
        names = {*(each.name for each in facts.plugin_uses), *(each.name for each in facts.plugins)}
        return not names.isdisjoint(removed("plugins").get(package, ())) and not self.distribution.names_supported

    def nodes(self) -> Iterator[ExecutableUse]:
        """Yield what is started of packages of the workspace, under literal names; a component is no program."""
        file, workspace = self.scope.file, self.scope.workspace
        for each in named_programs(file):
            facts, span = workspace.named(each.package), each.executable.span
            if facts is not None:
                name = each.executable.literal or ""
                level, why = milder(level_met(file, each.span, workspace), level_at(file, span))
                if each.is_command and not level:
                    level, why = "warning", "and the launch goes on"
                if not level and is_taken_by_old_launch_alone(file):
                    level, why = "warning", "where launch_ros still takes the other arguments (up to Foxy)"
                is_plain = file.source.slice(span) == name
                yield ExecutableUse(file.path, span, name, is_plain, facts, level, why, is_command=each.is_command)

    def unknown_executables(self) -> Iterator[ExecutableUse]:
        """Yield the nodes whose package installs no such executable anywhere; slips alone where not all are known.

        A path is not looked for in lib/<package>: `which()` of osrf_pycommon 2.0, which launch_ros asks, takes it from
        the current folder, and an absolute one as it is. Launch files of tests that CMake does not run are left alone.
        """
        if self.scope.is_unused_test:
            return
        for node in self.nodes():
            facts, name = node.facts, node.executable
            known = name in node.startable | facts.misplaced_executables or facts.may_write(name)
            is_told = facts.knows("executables") or bool(slips(name, node.startable))
            known |= node.is_command and bool(node.in_folder)
            if is_told and not known and not posixpath.isabs(name):
                yield replace(self.unless_blank(node), sister=self.sister(node), entry=self.entry(node))

    def unless_blank(self, node: ExecutableUse) -> ExecutableUse:
        """Return a use, as an info where people are to fill its name in (`TODO`, `<your_node>`) or to replace it."""
        from ..python.left_blank import is_blank, is_to_be_replaced  # what few launch files need

        is_open = is_blank(node.executable) or is_to_be_replaced(self.scope.file.source.text, node.span.start)
        return replace(node, level="info", why="until people fill the name in") if is_open else node

    def unknown_together(self) -> Iterator[list[CausedPlace[ExecutableUse]]]:
        """Yield the uses in the package of each unknown executable that is told in this file; the worst is first."""
        places = (
            CausedPlace((use.facts.name, use.executable), use.level, use.path, use.span, use)
            for each in (self.each_file if next(self.unknown_executables(), None) else ())
            for use in each.unknown_executables()
        )
        yield from told_at(self.scope.file.path, places)

    def renamed_together(self) -> Iterator[list[CausedPlace[WellKnownUse]]]:
        """Yield the uses in the package of each name that is told in this file, with their levels; the worst first."""
        places = (
            CausedPlace((use.package, use.name), each.level_of(use), each.scope.file.path, use.executable.span, use)
            for each in (self.each_file if next(self.renamed(), None) else ())
            for use in each.renamed()
        )
        yield from told_at(self.scope.file.path, places)

    def renamed(self) -> Iterator[WellKnownUse]:
        """Yield the nodes of well-known packages that are not here, under a name that these do not have."""
        file, workspace = self.scope.file, self.scope.workspace
        seen: set[Span] = set()  # a loop starts one node several times
        for each in named_programs(file) if not self.scope.is_unused_test else ():
            name, is_here = each.executable.literal or "", workspace.named(each.package) is not None
            wrong = None if is_here or each.is_command else wrong_name("programs", each.package, name)
            if wrong is not None and each.executable.span not in seen:
                seen.add(each.executable.span)
                level = milder(level_met(file, each.span, workspace), level_at(file, each.executable.span))
                from .other_sources import may_be_another  # few launch files start what is not there

                if other := may_be_another(each.package, workspace, self.scope.files):
                    level = "info", other
                is_plain = file.source.slice(each.executable.span) == name
                yield WellKnownUse(each.package, each.executable, name, wrong, *level, is_plain)

    def blank(self) -> Iterator[tuple[LaunchText, str]]:
        """Yield the executables and packages of nodes that hold nothing, and packages with a blank."""
        for node in self.scope.file.nodes if not self.scope.file.is_ros1 else ():
            for text, what in ((node.executable, "executable"), (node.package, "package")):
                if text is not None and text.literal is not None:
                    bare = text.literal.strip()
                    if not bare or (what == "package" and bare.split() != [text.literal]):
                        yield text, what

    def entry(self, node: ExecutableUse) -> str:
        """Return the only executable of this package that starts the module whose name a node has; "" for none."""
        table, module = self.scope.table, node.executable.removesuffix(".py")
        if table is None or node.facts is not self.scope.package:
            return ""
        rows = (row for row in table.of("executable") if row.entry.partition(":")[0].rpartition(".")[2] == module)
        names = {row.destination.rpartition("/")[2] for row in rows}
        return names.pop() if len(names) == 1 else ""

    def sister(self, node: ExecutableUse) -> str:
        having = (each.name for each in self.scope.workspace.having("executables", node.executable))
        return next(having, "")


MILDEST: tuple[Level | None, ...] = ("info", "warning", None)


def milder(one: tuple[Level | None, str], other: tuple[Level | None, str]) -> tuple[Level | None, str]:
    """Return the milder of two levels: of an action that a function makes, and of the name that it is given."""
    return min(one, other, key=lambda each: MILDEST.index(each[0]))
