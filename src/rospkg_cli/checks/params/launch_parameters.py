"""Parameter files and values that launch files give to nodes."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import Substitution
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...unreadable import READABLE, Unreadable
from ..launch.ros1_syntax import is_refused
from .node_parameters import NodeArguments
from .parameter_file_paths import ParameterFilePaths

ENDINGS = (".yaml", ".yml")


@dataclass(frozen=True)
class LaunchParameters:
    files: Annotated[tuple[ParameterFile, ...], READABLE]
    launches: Annotated[tuple[LaunchFile, ...], READABLE]
    table: InstallTable | None
    package: PackageFacts
    workspace: Workspace
    unreadable: tuple[Unreadable, ...] = ()

    @cached_property
    def paths(self) -> ParameterFilePaths:
        return ParameterFilePaths(self.files, self.package, self.table)

    @property
    def is_whole(self) -> bool:
        """Whether all launch files and parameter files can be read: else another may start a node, or be for it."""
        return not any(role_of(each.path) == "launch" or each.path.endswith(ENDINGS) for each in self.unreadable)

    @cached_property
    def node_arguments(self) -> tuple[NodeArguments, ...]:
        return tuple(
            self.arguments_of(launch, node) for launch in self.launches if not launch.is_ros1 for node in launch.nodes
        )

    @cached_property
    def started(self) -> tuple[NodeArguments, ...]:
        """The nodes of launch files that ROS 2 accepts; others are reported first (LCH006)."""
        return tuple(each for each in self.node_arguments if not is_refused(each.launch))

    def is_left_out(self, launch: LaunchFile) -> bool:
        """Return whether a launch file is known not to be installed: then it is only started by its path in the source.

        Tests are run from there.
        """
        if self.table is None or not self.table.knows("share") or role_of(launch.path) == "test":
            return False
        return all(row.source != launch.path for _, row in self.table.below(f"share/{self.package.name}"))

    def arguments_of(self, launch: LaunchFile, node: LaunchedNode) -> NodeArguments:
        found: list[ParameterFile] = []
        has_all = node.is_complete
        for entry in node.parameters:
            has_names = all(name.literal is not None for name, _ in entry.values)
            has_all = has_all and entry.is_complete and has_names
            if entry.file is not None:
                files = list(self.paths.files_at(entry.file, launch))
                has_all = has_all and len(files) == 1
                found += files
        in_code = self.name_in_code(node) if self.files else None
        is_complete, default = has_all and node.is_certain, default_name(launch, node)
        return NodeArguments(launch, node, tuple(found), is_complete, has_all, in_code, default)

    def name_in_code(self, node: LaunchedNode) -> str | None:
        """Return the name that the code of a node gives it, where nothing else does."""
        started = node.executable or node.plugin
        package = node.package.literal if node.package is not None else None
        facts = self.workspace.named(package) if package and node.name is None and node.is_complete else None
        if facts is None or started is None or any("__n" in (each.literal or "__n") for each in node.arguments):
            return None
        return next((each.name for each in facts.node_names if each.starts == started.literal), None)


def default_name(launch: LaunchFile, node: LaunchedNode) -> str | None:
    """Return the name of a node that is one launch argument, as its only default has it."""
    parts = node.name.parts if node.name is not None else ()
    if len(parts) != 1 or not isinstance(parts[0], Substitution) or parts[0].name != "var":
        return None
    wanted = parts[0].arguments[0].literal if parts[0].arguments else None
    defaults = [each.default for each in launch.arguments if each.name.literal == wanted and wanted]
    return defaults[0].literal if len(defaults) == 1 and defaults[0] is not None else None
