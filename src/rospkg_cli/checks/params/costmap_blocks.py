"""Blocks for the costmaps of nav2: each of these nodes is in a namespace that has its own name."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import default_of
from .inner_nodes import COSTMAPS
from .launch_parameters import LaunchParameters
from .mistyped_blocks import last

DEFAULTS = {
    "always_send_full_costmap": "false", "filters": "[]", "footprint": "[]", "footprint_padding": "0.01",
    "global_frame": "map", "height": "5", "lethal_cost_threshold": "100", "map_topic": "map",
    "plugins": "[static_layer, obstacle_layer, inflation_layer]", "publish_frequency": "1.0",
    "resolution": "0.1", "robot_base_frame": "base_link", "robot_radius": "0.1",
    "rolling_window": "false", "track_unknown_space": "false", "transform_tolerance": "0.3", "trinary_costmap": "true",
    "update_frequency": "5.0", "use_maximum": "false", "use_sim_time": "false", "width": "5",
}  # fmt: skip
"""What the node takes where nothing is given. (nav2_costmap_2d/src/costmap_2d_ros.cpp)"""
FILLED_OR_WILD = "*$<{@"


def is_out_of_reach(block: NodeBlock, launched: LaunchParameters) -> bool:
    """Return whether a block is for a costmap and not below its namespace, and nothing here has a node of that name."""
    name = last(block)
    if name not in COSTMAPS or any(sign in block.name for sign in FILLED_OR_WILD):
        return False
    if f"/{block.name}".endswith(f"/{name}/{name}"):
        return False
    coded = (each.name for facts in launched.workspace.packages for each in facts.node_names)
    return all(each.known_name != name for each in launched.node_arguments) and name not in coded


def unread_costmaps(launched: LaunchParameters) -> Iterator[tuple[ParameterFile, NodeBlock, NodeBlock]]:
    """Yield the blocks that no costmap reads, each with the block of its server in the same file."""
    for file in launched.files:
        named = {last(block): block for block in file.blocks}
        lost = [block for block in file.blocks if is_out_of_reach(block, launched)]
        for block in lost:
            alike = [each for each in file.blocks if last(each) == last(block)]
            server = named.get(COSTMAPS[last(block)])
            if server is not None and all(any(one is each for one in lost) for each in alike):
                yield file, block, server


def costmap_defaults(name: str) -> tuple[str, ...]:
    """Return the default of a parameter of a costmap or of one of its layers, "" where it is not known."""
    return (DEFAULTS.get(name) or default_of("nav2_costmap_2d", name),)


def costmap_message(block: NodeBlock, maker: NodeBlock, same: str) -> str:
    """Return the message about a block for the costmap that a server makes.

    `maker` is the block of that server; `same` says why the lost values change nothing, or is "".
    """
    name, server = block.key.text, maker.key.text
    message = f"no node is called `{name}`: the costmap that `{server}` makes is `{name}/{name}`"
    return f"{message}, and never reads the block{same}; write `{name}:` twice, one below the other"
