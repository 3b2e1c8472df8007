"""A node that a launch file starts, its name, and the parameter files and values that it is given."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from .mistyped_blocks import WILD, last


@dataclass(frozen=True)
class NodeArguments:
    """A node that a launch file starts, and the parameter files of this package that may be passed to it."""

    launch: LaunchFile
    node: LaunchedNode
    files: tuple[ParameterFile, ...]
    is_complete: bool
    """Whether these are certainly all, and the node is certainly started."""
    has_all: bool = False
    """Whether these are certainly all, if the node is started."""
    in_code: str | None = None
    """The name that its code gives it, where the launch file gives none."""
    by_default: str | None = None
    """The name that the defaults of arguments give it."""

    @property
    def name(self) -> str | None:
        return self.node.name.literal if self.node.name else None

    @property
    def known_name(self) -> str | None:
        return self.name or self.in_code or self.by_default

    @property
    def usual_name(self) -> str | None:
        """The same; that of a well-known node is mostly that of its program."""
        program = self.node.executable.literal if self.node.executable and self.node.name is None else None
        package = self.node.package.literal if self.node.package else None
        return self.known_name or (program if package in known_nodes().get(program or "", ()) else None)

    @property
    def likely_name(self) -> str | None:
        """The same; where it is unknown, that of the program, which is often the node's."""
        return self.known_name or (self.node.executable.literal if self.node.executable else None)

    def starts(self, executable: str) -> bool:
        """Return whether the node has an executable of this name, which is often that of a node without `name=`."""
        return self.node.executable is not None and self.node.executable.literal == executable

    @property
    def full_name(self) -> str | None:
        """The name with its namespace, where both are literal; others may be put before it, but for an absolute one."""
        space = self.node.namespace.literal if self.node.namespace else None
        return f"/{space.strip('/')}/{self.known_name}" if space and space.strip("/") and self.known_name else None

    def blocks(self) -> Iterator[NodeBlock]:
        """Yield the blocks that the node reads."""
        for file in self.files:
            for block in file.blocks:
                if self.name is None or last(block) in (*WILD, self.name):
                    yield block

    def names(self) -> set[str]:
        """Return the names of the parameters that are set for the node."""
        values = [name.literal for entry in self.node.parameters for name, _ in entry.values]
        return {each.name for block in self.blocks() for each in block.parameters} | {name for name in values if name}
