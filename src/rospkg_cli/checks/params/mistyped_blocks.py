"""Blocks of parameters whose name is nearly that of a controller of the same file, or of a node that everybody uses."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from ...languages.yaml.nodes import ScalarNode
from ...light_dataclasses import dataclass
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ...suggest import near_names

MANAGER = "controller_manager"
TYPE = ".type"
WILD = ("*", "**")


@dataclass(frozen=True, slots=True)
class MistypedBlock:
    block: NodeBlock
    meant: str
    by: str
    """What has that name: the key of the controller manager, or a package."""
    is_controller: bool


def mistyped_blocks(
    file: ParameterFile, started: Collection[str | None], texts: Iterable[str]
) -> Iterator[MistypedBlock]:
    """Yield the blocks of a file that no node reads, where the one that is meant has no block in it.

    `started` are the names of nodes that launch files give; `texts` are those of launch files, which may load a
    controller by name.
    """
    named = {last(block) for block in file.blocks}
    listed = dict(controllers(file))
    for block in file.blocks:
        key = last(block)
        if key in started or key in WILD or "$" in key or key in listed or key in known_nodes():
            continue
        found = differing(key, near_names(key, listed.keys() - named))
        known = found or differing(key, near_names(key, known_nodes().keys() - named, 1))
        if len(known) == 1 and not any(key in text for text in texts):
            by = listed[known[0]] if found else known_nodes()[known[0]][0]
            yield MistypedBlock(block, known[0], by, bool(found))


def controllers(file: ParameterFile) -> Iterator[tuple[str, str]]:
    """Yield the controllers that the blocks of controller managers give a type, with the name of that block."""
    for block in file.blocks:
        if last(block).endswith(MANAGER):
            for each in block.parameters:
                if each.name.endswith(TYPE) and isinstance(each.value, ScalarNode):
                    yield each.name.removesuffix(TYPE), last(block)


def differing(word: str, names: Iterable[str]) -> list[str]:
    """Return the names that differ from a word by more than a number: `arm_1` and `arm_2` are two nodes."""
    return [each for each in names if re.sub(r"[\d_]", "", each) != re.sub(r"[\d_]", "", word)]


def last(block: NodeBlock) -> str:
    """Return the name of a block's node, without its namespace."""
    return block.name.rpartition("/")[2]
