"""Parameter files that no launch file gives to a node, with a block for a node that the package does not have."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ...ros.well_known import packages_with_plugin
from .block_readers import BlockReaders
from .declaring_packages import is_its_own
from .known_given import controller_types
from .launch_parameters import LaunchParameters
from .mistyped_blocks import WILD, MistypedBlock, last
from .node_parameters import NodeArguments
from .parameter_file_use import ParameterFileUses
from .unchanged_values import ONLY_DEFAULTS, defaults_in, holds_defaults

NAMING = (".py", ".xml", ".launch", ".yaml", ".yml", ".sh", ".bash", ".cpp", ".hpp", ".md", ".rst", "Dockerfile")


@dataclass(frozen=True)
class NodeBlocks:
    """Rule input: the blocks of parameter files, and which nodes are given the files (PRM003)."""

    launched: LaunchParameters
    uses: ParameterFileUses
    readers: BlockReaders

    def unread(self) -> Iterator[tuple[ParameterFile, NodeBlock, str]]:
        """Yield each block that the one node of the package does not read, with the name of that node.

        The package declares all that the block sets, no text names a node like it, and no launch file names nodes of
        the package anew.
        """
        names = {each.name for each in self.launched.package.node_names}
        is_renamed = any(each.node.name is not None for each in self.launched.node_arguments)
        if len(names) != 1 or is_renamed or self.launched.package.executables - self.named_programs:
            return
        (name,) = names
        for file in self.launched.files:
            keys = {last(block) for block in file.blocks}
            if name in keys or not self.uses.of(file).is_unnamed:
                continue
            for block in file.blocks:
                key = last(block)
                if key not in WILD and re.fullmatch(r"\w+", key) and self.is_declared(block) and not self.has(key):
                    yield file, block, name

    def why_not_sure(self, file: ParameterFile, block: NodeBlock, nodes: list[NodeArguments]) -> str:
        """Return how another node may read a block than those that lack one; "" where none can."""
        from .sure_blocks import SureBlocks  # few packages need it

        return SureBlocks(self.launched, self.uses.files).why_not(file, block, nodes)

    def lost_nothing(self, block: NodeBlock, intended: Iterable[NodeArguments]) -> str:
        """Return why losing a block that is for some nodes changes nothing; "" where something may differ."""
        packages = {each.node.package.literal for each in intended if each.node.package is not None}
        return ONLY_DEFAULTS if holds_defaults(block, defaults_in(packages, self.launched.workspace)) else ""

    def lost_nothing_of(self, file: ParameterFile, wrong: MistypedBlock) -> str:
        """Return the same of a block for a controller, or for a well-known node."""
        types = dict(controller_types(file)) if wrong.is_controller else {}
        packages = packages_with_plugin(types.get(wrong.intended, "")) or known_nodes().get(wrong.intended, ())
        return ONLY_DEFAULTS if holds_defaults(wrong.block, defaults_in(packages, self.launched.workspace)) else ""

    @property
    def named_programs(self) -> frozenset[str]:
        return frozenset(each.starts for each in self.launched.package.node_names)

    def is_declared(self, block: NodeBlock) -> bool:
        """Return whether the package declares all that a block sets."""
        names = [each.name for each in block.parameters if is_its_own(each.name)]
        declared = self.launched.package.parameters
        return bool(names) and all(any(one.fits(name) for one in declared) for name in names)

    def has(self, key: str) -> bool:
        """Return whether a text may give a node a name: `__node:=key`, or in quotes."""
        named = re.compile(rf"['\"/]{key}['\"]|name:=['\"]?{key}\b|__node:=['\"]?/?{key}\b|\bname:\s*['\"]?{key}\b")
        files = self.uses.files
        return any(named.search(files.readable_text(path)) for path in files.paths if path.endswith(NAMING))


def shown_block(block: NodeBlock, may: str) -> str:
    """Return that no node has a block's name, or that none is started where one may have it."""
    return f"{'nothing here starts a node' if may else 'no node is called'} `{block.key.text}`"


def shown_readers(given: NodeArguments, names: list[str]) -> str:
    """Return which nodes get the file, and that none of them reads the block."""
    by = "" if given.name else " by its code" if given.in_code else " by default"
    if len(names) == 1:
        return (
            f"the one that `{given.launch.path}` gives this file to is `{names[0]}`{by}, and it never reads the block"
        )
    listed = f"{', '.join(f'`{name}`' for name in names[:-1])} and `{names[-1]}`"
    return f"those that `{given.launch.path}` gives this file to are {listed}, and they never read the block"
