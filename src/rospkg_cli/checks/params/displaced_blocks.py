"""Blocks of parameter files for a node that is started in another namespace than they say (PRM003)."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.params.parameter_file import NodeBlock, ParameterFile
from ..yaml_elsewhere import is_named_elsewhere
from .launch_parameters import LaunchParameters
from .mistyped_blocks import last
from .node_parameters import NodeArguments


def displaced_blocks(launched: LaunchParameters) -> Iterator[tuple[ParameterFile, NodeBlock, NodeArguments]]:
    """Yield the blocks that a node does not read, as it is in another namespace than the block says.

    `talker` is rcl's for `/talker`, and for no node in a namespace; launch_ros is milder with components.
    """
    for file in launched.files:
        for block in file.blocks if is_only_here(launched, file) else ():
            is_wild = any(sign in block.name for sign in "*$<{")
            same = [each for each in launched.node_arguments if each.known_name == last(block) and not is_wild]
            is_spaced = "/" in block.name.strip("/")
            nodes = same if is_spaced else [each for each in same if file in each.files]
            if is_spaced or all(each.node.kind != "composable_node" for each in nodes):
                names = [each.full_name or "" for each in nodes]
                if names and all(name and not f"/{block.name.strip('/')}".endswith(name) for name in names):
                    yield file, block, nodes[0]


def is_only_here(launched: LaunchParameters, file: ParameterFile) -> bool:
    """Return whether only launch files that give a file to nodes name it, and the names of these nodes are known."""
    given = [each for each in launched.node_arguments if file in each.files]
    name = file.path.rpartition("/")[2]
    others = [launch for launch in launched.launches if all(each.launch is not launch for each in given)]
    return bool(given) and all(each.known_name for each in given) and not any(name in one.source.text for one in others)


def why_not(launched: LaunchParameters, file: ParameterFile, block: NodeBlock) -> str:
    """Return how a node may still read such a block; "" where none can.

    A file has the node's name in several namespaces, of which the launch file takes one, or another package starts it.
    """
    if any(last(each) == last(block) and each.name.strip("/") != block.name.strip("/") for each in file.blocks):
        return ", unless another of the namespaces in this file is chosen"
    stem = file.path.rpartition("/")[2].rpartition(".")[0]
    is_elsewhere = is_named_elsewhere(stem, launched.package, launched.workspace)
    return ", unless another package starts it elsewhere" if is_elsewhere else ""


def displaced_message(block: NodeBlock, given: NodeArguments) -> str:
    """Return what is wrong with a block that a node does not read."""
    message = f"`{block.name}` is no node: the one that `{given.launch.path}` starts is `{given.full_name}`"
    return f"{message}, which never reads the block"
