"""Whether anything may read a block of a parameter file: rcl gives it to nodes of its name alone."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ...source import Span
from ..yaml_elsewhere import is_named_elsewhere
from .costmap_blocks import is_out_of_reach
from .displaced_blocks import displaced_blocks
from .handed_on import may_hand_on
from .idle_nodes import may_start, start_of
from .inner_nodes import COSTMAPS
from .launch_parameters import LaunchParameters
from .misnamed_blocks import misnamed_blocks
from .mistyped_blocks import WILD, last
from .node_parameters import NodeArguments
from .parameter_file_use import ParameterFileUses
from .refused_files import is_refused

TO_SPAWNERS = "param-file"
"""How a spawner is given a file, for a controller whose name is not that of a node here."""

AUTOSTART = "autostart_node"
"""A parameter by which a node of nav2 configures itself."""


@dataclass(frozen=True)
class BlockReaders:
    """The parameter files of a package, and the nodes that launch files give them to."""

    launched: LaunchParameters
    uses: ParameterFileUses

    def is_idle(self, path: str, place: Span) -> bool:
        """Return whether a place is in a file that nothing opens or rcl refuses, or in a block that no node reads."""
        file = next((each for each in self.launched.files if each.path == path), None)
        blocks = file.blocks if file is not None else ()
        block = next((each for each in blocks if each.key.span == place or each.value.span.holds(place)), None)
        if file is None or self.is_unopened(file) or self.is_refused(file):
            return file is not None
        return block is not None and (self.is_unread(file, block) or self.is_given_otherwise(path, place))

    def is_given_otherwise(self, path: str, place: Span) -> bool:
        """Return whether every launch file that passes a file on gives the parameter at a place another value."""
        from .launch_overrides import is_overridden  # few packages need it

        return is_overridden(path, place, self.launched.files, self.launched.launches)

    def is_refused(self, file: ParameterFile) -> bool:
        """Return whether rcl refuses a file that no component gets; for components launch_ros reads it with PyYAML."""
        has_components = any(each.node.kind == "composable_node" for each in self.given(file))
        return not has_components and is_refused(self.uses.of(file))

    def is_unopened(self, file: ParameterFile) -> bool:
        """Return whether nothing names a file, or launch files give it only to nodes that are never started."""
        from .ignored_files import is_ignored  # few packages need it

        given = self.given(file)
        is_dead = bool(given) and not any(map(self.is_met, given)) and self.is_only_given(file, given)
        return is_dead or self.uses.of(file).is_unnamed or is_ignored(self.uses.of(file), self.launched.launches)

    def is_unread(self, file: ParameterFile, block: NodeBlock) -> bool:
        """Return whether launch files give a file to nodes, and none of those that they start reads a block of it."""
        given = self.given(file)
        met = [each for each in given if self.is_met(each)]
        awake = [each for each in met if not self.is_asleep(each, block)]
        if not met or any(may_read(each, block) for each in awake) or not self.is_only_given(file, given):
            return False
        return any(may_read(each, block) for each in given) or self.is_for_others(block, met)

    def is_read_by_python(self, file: ParameterFile, block: NodeBlock) -> bool:
        """Return whether a component that is started reads a block: launch_ros reads its files with PyYAML, not rcl."""
        components = (each for each in self.given(file) if each.node.kind == "composable_node")
        return any(may_read(each, block) and self.is_met(each) for each in components)

    def given(self, file: ParameterFile) -> list[NodeArguments]:
        return [each for each in self.launched.node_arguments if file in each.files]

    def is_met(self, each: NodeArguments) -> bool:
        """Return whether a node may be started: its action is added, and its launch file is not left out."""
        is_out = is_set_aside(each.launch.path) or self.launched.is_left_out(each.launch)
        return may_start(start_of(each.launch, each.node, self.launched.workspace)) and not is_out

    def is_asleep(self, each: NodeArguments, block: NodeBlock) -> bool:
        """Return whether a node would read a block, and nothing configures it."""
        from .unmanaged_nodes import is_unmanaged  # few packages need it

        is_named = last(block) == each.usual_name and not any(one.name == AUTOSTART for one in block.parameters)
        return is_named and is_unmanaged(each, self.launched)

    def is_only_given(self, file: ParameterFile, given: list[NodeArguments]) -> bool:
        """Return whether launch files give a file to some nodes alone, and nothing else opens it."""
        name, package, workspace = file.path.rpartition("/")[2], self.launched.package, self.launched.workspace
        giving = {each.launch.path: each.launch for each in given}
        others = (launch.source.text for launch in self.launched.launches if launch.path not in giving)
        if any(name in text for text in others) or any(TO_SPAWNERS in each.source.text for each in giving.values()):
            return False
        if is_named_elsewhere(name.rpartition(".")[0], package, workspace):
            return False
        return not any(may_hand_on(each, name, workspace) for each in giving.values())

    def is_for_others(self, block: NodeBlock, given: list[NodeArguments]) -> bool:
        """Return whether no started node has the name of a block, as far as names are known."""
        reported = (
            *(each for _, each, _ in misnamed_blocks(self.launched)),
            *(b for _, b, _ in displaced_blocks(self.launched)),
        )
        if any(each is block for each in reported) or is_out_of_reach(block, self.launched):
            return True
        name = COSTMAPS.get(last(block), last(block))
        packages = {each.node.package.literal if each.node.package else None for each in given}
        owners = known_nodes().get(name, ())
        if any(each.name == name for facts in self.launched.workspace.packages for each in facts.node_names):
            return True
        return bool(owners) and None not in packages and packages.isdisjoint(owners)


def may_read(each: NodeArguments, block: NodeBlock) -> bool:
    """Return whether a node may read a block; a server of nav2 makes a costmap, which gets the same files."""
    names = (last(block), COSTMAPS.get(last(block)))
    return last(block) in WILD or each.usual_name is None or each.usual_name in names
