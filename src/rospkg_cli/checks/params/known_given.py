"""What is given to nodes, controllers and plugins of well-known packages, with what these declare."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import ScalarNode
from ...light_dataclasses import dataclass
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from ...ros.known_nodes import known_nodes, known_parameters
from ...ros.well_known import packages_with_plugin
from .costmap_blocks import is_out_of_reach
from .declaring_packages import is_its_own
from .given_values import file_value, launch_value
from .idle_nodes import start_of
from .known_group import KnownGroup, PartKind
from .launch_parameters import LaunchParameters
from .mistyped_blocks import MANAGER, TYPE, WILD, last
from .node_parameters import NodeArguments
from .plugin_lists import is_unloaded

PLUGIN = ".plugin"
SEVERAL = 3
"""Blocks of well-known nodes in one file, by which it is one for all of them: nav2's."""
SELDOM = frozenset({"map_saver"})
"""Nodes with a block in each such file that are seldom started."""


@dataclass(frozen=True)
class KnownNodes:
    launched: LaunchParameters

    def groups(self) -> Iterator[KnownGroup]:
        """Yield what launch files and parameter files give."""
        for each in self.launched.started:
            package = each.node.package.literal if each.node.package else None
            if package and self.is_known(package):
                entries = (pair for entry in each.node.parameters for pair in entry.values)
                values = tuple(found for name, value in entries for found in launch_value(each.launch, name, value))
                start = start_of(each.launch, each.node, self.launched.workspace)
                yield KnownGroup(each.launch.path, "node", (package,), values, start=start)
        for file in self.launched.files:
            kinds = dict(controller_types(file))
            for block in file.blocks:
                if not is_out_of_reach(block, self.launched):
                    yield from self.of_block(file, block, kinds)

    def of_block(self, file: ParameterFile, block: NodeBlock, kinds: dict[str, str]) -> Iterator[KnownGroup]:
        """Yield the values of a block: those of the node, and those below the name of each plugin."""
        plugins = {
            each.name.removesuffix(PLUGIN): each.value.text
            for each in block.parameters
            if each.name.endswith(PLUGIN) and isinstance(each.value, ScalarNode)
        }
        parts: dict[str, list[Parameter]] = {}
        for each in block.parameters:
            owner = max((name for name in plugins if each.name.startswith(f"{name}.")), key=len, default="")
            if is_its_own(each.name) and each.name != owner + PLUGIN:
                parts.setdefault(owner, []).append(each)
        for owner, parameters in parts.items():
            packages = self.having(plugins[owner]) if owner else self.behind(file, block, kinds)
            if packages:
                kind: PartKind = "plugin" if owner else "controller" if last(block) in kinds else "node"
                is_certain = kind != "node" or self.is_certain(file, block)
                is_certain = is_certain and not (kind == "plugin" and is_unloaded(block, owner))
                yield KnownGroup(file.path, kind, packages, tuple(map(file_value, parameters)), file, is_certain)

    def readers(self, file: ParameterFile, key: str) -> list[NodeArguments]:
        """Return the nodes that launch files give a file, and that read a block of a name."""
        given = (each for each in self.launched.node_arguments if file in each.files)
        return [each for each in given if key in WILD or key in (each.name, each.usual_name) or each.usual_name is None]

    def is_certain(self, file: ParameterFile, block: NodeBlock) -> bool:
        """Return whether a launch file gives the node the file, or it stands among several nodes of well-known sets."""
        if self.readers(file, last(block)):
            return True
        together = {last(each) for each in file.blocks} & known_nodes().keys()
        return len(together) >= SEVERAL and last(block) not in SELDOM

    def behind(self, file: ParameterFile, block: NodeBlock, kinds: dict[str, str]) -> tuple[str, ...]:
        """Return the packages of the nodes that a block is for; none where not all of them are known."""
        key = last(block)
        if key in kinds:
            return self.having(kinds[key])
        readers = self.readers(file, key)
        named = {each.node.package.literal if each.node.package else None for each in readers}
        found = named or set(known_nodes().get(key, ()))
        return tuple(sorted(each or "" for each in found)) if all(map(self.is_known, found)) else ()

    def having(self, plugin: str) -> tuple[str, ...]:
        """Return the packages that have a plugin; none where one is in the workspace."""
        found = packages_with_plugin(plugin)
        return found if all(map(self.is_known, found)) else ()

    def is_known(self, package: str | None) -> bool:
        """Return whether a package is well-known, and not among those whose sources are here."""
        return bool(package and known_parameters(package)) and self.launched.workspace.named(package or "") is None


def controller_types(file: ParameterFile) -> Iterator[tuple[str, str]]:
    """Yield the controllers that controller managers of a file load, with their types."""
    for block in file.blocks:
        for each in block.parameters if last(block).endswith(MANAGER) else ():
            if each.name.endswith(TYPE) and isinstance(each.value, ScalarNode):
                yield each.name.removesuffix(TYPE), each.value.text
