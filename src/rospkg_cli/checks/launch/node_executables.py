"""Rule input: the executables that a launch file starts, and the other launch files of its package (LCH002)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...unreadable import READABLE
from ..fault import Level
from ..repository.older_distribution import OlderDistribution
from .executable_use import ExecutableUse
from .idle_actions import level_at
from .launch_context import LaunchContext
from .named_programs import named_programs
from .removed_arguments import is_taken_by_old_launch_alone
from .who_meets import level_met


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

    def blank(self) -> Iterator[tuple[LaunchText, str]]:
        """Yield the executables and packages of nodes that hold nothing, and packages with a blank."""
        for node in self.scope.file.nodes if not self.scope.file.is_ros1 else ():
            for text, what in ((node.executable, "executable"), (node.package, "package")):
                if text is not None and text.literal is not None:
                    bare = text.literal.strip()
                    if not bare or (what == "package" and bare.split() != [text.literal]):
                        yield text, what


MILDEST: tuple[Level | None, ...] = ("info", "warning", None)


def milder(one: tuple[Level | None, str], other: tuple[Level | None, str]) -> tuple[Level | None, str]:
    """Return the milder of two levels: of an action that a function makes, and of the name that it is given."""
    return min(one, other, key=lambda each: MILDEST.index(each[0]))
