"""Rule input: what nodes need, what launch files and parameter files give them, and who reads these (PRM008)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...source import Span
from ..fault import Level
from .block_readers import BlockReaders
from .declaring_packages import ParameterContext
from .launch_parameters import LaunchParameters


@dataclass(frozen=True)
class MissingParameters:
    readers: BlockReaders
    code: ParameterContext

    @property
    def launched(self) -> LaunchParameters:
        return self.readers.launched

    def level_at(self, path: str, place: Span) -> Level | None:
        """Return the level of what a parameter file lacks: an info where no node reads the block at a place."""
        return "info" if self.readers.is_idle(path, place) else None
