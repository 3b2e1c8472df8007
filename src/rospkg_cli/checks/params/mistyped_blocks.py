"""Blocks of parameters whose name is nearly that of a controller of the same file, or of a well-known node."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from ...languages.yaml.nodes import ScalarNode
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ...source import Span
from ...suggest import near_names

MANAGER = "controller_manager"
TYPE = ".type"
TYPING = frozenset({"-t", "--controller-type", "-p", "--param-file"})
"""Options of the spawner by which a controller gets its type."""
Spawn = tuple[LaunchFile, str, Span, str, bool]
"""The launch file, the name of the controller, its place, the intended name, whether the spawner gives a type."""
WILD = ("*", "**")


@dataclass(frozen=True, slots=True)
class MistypedBlock:
    block: NodeBlock
    intended: str
    by: str
    """What has that name: the key of the controller manager, or a package."""
    is_controller: bool

    @property
    def owner(self) -> str:
        """What has that name: part of a sentence."""
        start = f"`{self.by}` starts" if self.is_controller else f"that of `{self.by}` is"
        return f"{start} `{self.intended}`, which has no block here"


def mistyped_blocks(
    file: ParameterFile, started: Collection[str | None], texts: Iterable[str]
) -> Iterator[MistypedBlock]:
    """Yield the blocks of a file that no node reads, where a similar name has no block.

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


def misspelt_spawns(files: Iterable[ParameterFile], launches: Iterable[LaunchFile]) -> Iterator[Spawn]:
    """Yield the controllers that are spawned with nearly the name of one that has a type here and is not spawned."""
    listed = {name for file in files for name, _ in controllers(file)}
    spawns = [each for launch in launches if listed and not launch.is_ros1 for each in spawned(launch)]
    free = listed - {name for _, name, *_ in spawns}
    for launch, name, span, is_typed in spawns:
        near = differing(name, near_names(name, free)) if name not in listed else []
        if len(near) == 1:
            yield launch, name, span, near[0], is_typed


def spawned(launch: LaunchFile) -> Iterator[tuple[LaunchFile, str, Span, bool]]:
    """Yield the controllers that spawners of a launch file are given, up to the first option, and whether these may
    give them a type.
    """
    for node in launch.nodes:
        names = (node.package, node.executable)
        is_typed = any((word.literal or "").partition("=")[0] in TYPING for word in node.arguments)
        if [text.literal if text else None for text in names] == [MANAGER, "spawner"]:
            for word in node.arguments:
                if word.literal is None or word.literal.startswith("-"):
                    break
                yield launch, word.literal, word.span, is_typed


def differing(word: str, names: Iterable[str]) -> list[str]:
    """Return the names that differ from a word by more than a number: `arm_1` and `arm_2` are two nodes."""
    return [each for each in names if re.sub(r"[\d_]", "", each) != re.sub(r"[\d_]", "", word)]


def last(block: NodeBlock) -> str:
    """Return the name of a block's node, without its namespace."""
    return block.name.rpartition("/")[2]
