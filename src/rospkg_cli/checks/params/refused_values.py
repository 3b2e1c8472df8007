"""Rule input: a parameter file with what rcl refuses in it, and the nodes that would stop at that (PRM004)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...source import Span
from .block_readers import BlockReaders
from .parameter_file_use import ParameterFileUse


@dataclass(frozen=True)
class RefusedValues:
    use: ParameterFileUse
    readers: BlockReaders

    def is_unread(self, place: Span) -> bool:
        """Return whether no node reads the block at a place: rclcpp converts the values of its own blocks alone."""
        return self.readers.is_idle(self.use.file.path, place)
