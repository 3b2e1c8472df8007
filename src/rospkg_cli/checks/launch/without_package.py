"""Nodes without a package, whose executable is not on the PATH (LCH002)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import LaunchText
from ...ros.well_known import packages_with_program
from ..fault import Level
from .entity_schema import entity_faults
from .launch_context import LaunchContext
from .who_meets import level_met

PROGRAMS = ("node", "lifecycle_node", "node_container")


@dataclass(frozen=True, slots=True)
class PathUse:
    """A node that launch looks for on the PATH, though a package installs it into its own folder."""

    executable: LaunchText
    packages: tuple[str, ...]
    level: Level | None
    why: str


@dataclass(frozen=True)
class NodesWithoutPackage:
    scope: LaunchContext

    def uses(self) -> Iterator[PathUse]:
        """Yield the nodes whose executable a package has, one here or a well-known one, and none puts into bin/."""
        file = self.scope.file
        is_refused = any(entity_faults(file))  # as a whole, which LCH007 reports
        for node in file.nodes if not (self.scope.is_unused_test or is_refused) else ():
            executable = node.executable
            if is_without_package(node) and executable is not None and executable.literal:
                packages = self.packages_with(executable.literal)
                if packages:
                    yield PathUse(executable, packages, *level_met(file, node.span, self.scope.workspace))

    def packages_with(self, executable: str) -> tuple[str, ...]:
        """Return the packages that have an executable in lib/<package>; none where it may be on the PATH."""
        workspace = self.scope.workspace
        if workspace.having("misplaced_executables", executable):
            return ()
        here = tuple(sorted(each.name for each in workspace.having("executables", executable)))
        return here or packages_with_program(executable)


def is_without_package(node: LaunchedNode) -> bool:
    return node.kind in PROGRAMS and node.package is None and node.is_complete
