"""Blocks of parameter files that no node reads, where a node that gets the file has a similar name (PRM003)."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ...suggest import near_names
from ..yaml_elsewhere import is_named_elsewhere
from .declaring_packages import is_its_own
from .handed_on import may_hand_on
from .inner_nodes import may_make
from .launch_parameters import LaunchParameters
from .mistyped_blocks import WILD, MistypedBlock, differing, last, mistyped_blocks
from .node_parameters import NodeArguments

ENOUGH_NAMES = 2
"""What a block has to set to be known by it."""


def misnamed_blocks(launched: LaunchParameters) -> Iterator[tuple[ParameterFile, NodeBlock, list[NodeArguments]]]:
    """Yield the blocks that no node reads, where a node that gets the file has a similar name and no block.

    Where the file goes to no other node, the names need not be alike: it has one block, be it for several nodes, or
    the code of the node declares what the block sets.
    """
    started = {each.likely_name for each in launched.node_arguments}
    for file in launched.files:
        readers = [each for each in launched.node_arguments if file in each.files and each.known_name]
        named = {last(block) for block in file.blocks}
        without_block = [each for each in readers if each.known_name not in named]
        for block in file.blocks if without_block else ():
            key = last(block)
            if key not in started and key not in WILD and "$" not in key:
                found = [each for each in without_block if is_near(key, each.known_name or "") or each.starts(key)]
                if (
                    not found
                    and is_only_for_named(launched, file)
                    and not any(may_make(each.node, key) for each in readers)
                ):
                    is_only = len(file.blocks) == 1
                    found = [each for each in without_block if is_only or declares(launched, each, block)]
                is_alone = len(file.blocks) == 1 and found == readers and key not in known_nodes()
                if found and (is_alone or len({each.known_name for each in found}) == 1):
                    yield file, block, found


def declares(launched: LaunchParameters, each: NodeArguments, block: NodeBlock) -> bool:
    """Return whether the package of a node declares all that a block sets."""
    package = each.node.package.literal if each.node.package else None
    facts = launched.workspace.named(package) if package else None
    names = [parameter.name for parameter in block.parameters if is_its_own(parameter.name)]
    if facts is None or not names:
        return False
    declared = [one for one in facts.parameters if not one.tail]
    return all(any(one.fits(name) for one in declared) for name in names) and len(names) >= ENOUGH_NAMES


def mistyped_blocks_of(launched: LaunchParameters) -> Iterator[tuple[ParameterFile, MistypedBlock]]:
    """Yield the blocks of nodes that are not here, with nearly the name of a controller or a well-known node."""
    started = {each.name for each in launched.node_arguments}
    texts = [launch.source.text for launch in launched.launches]
    misnamed = {id(block) for _, block, _ in misnamed_blocks(launched)}
    for file in launched.files:
        yield from ((file, each) for each in mistyped_blocks(file, started, texts) if id(each.block) not in misnamed)


def is_only_for_named(launched: LaunchParameters, file: ParameterFile) -> bool:
    """Return whether all nodes that may get a file have a literal name, and nothing else opens or passes it on."""
    given = [each for each in launched.node_arguments if file in each.files]
    texts = [launch.source.text for launch in launched.launches if not any(each.launch is launch for each in given)]
    name = file.path.rpartition("/")[2]
    alone = all(each.known_name and each.node.is_certain for each in given) and not any(name in text for text in texts)
    alone = alone and not is_named_elsewhere(name.rpartition(".")[0], launched.package, launched.workspace)
    return alone and not any(may_hand_on(each.launch, name, launched.workspace) for each in given)


def is_near(key: str, name: str) -> bool:
    short, long = sorted((key, name), key=len)
    return long in (f"{short}_node", f"{short}node") or bool(differing(key, near_names(key, [name], 1)))
