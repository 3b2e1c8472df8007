"""Rule input: a parameter file with what rcl refuses in it, and the nodes that would stop at that (PRM001, PRM004)."""

from __future__ import annotations

from ...light_dataclasses import dataclass, replace
from ..fault import Fault, Level, softer_advice
from .block_readers import BlockReaders
from .list_readers import UNSHOWN, ListReaders
from .parameter_file_use import ParameterFileUse


@dataclass(frozen=True)
class RefusedValues:
    use: ParameterFileUse
    readers: BlockReaders

    @property
    def level(self) -> Level | None:
        """The level of what rcl refuses: an info where only nodes that nobody starts are given the file."""
        return "info" if self.readers.is_unopened(self.use.file) else self.use.level

    def at_its_level(self, fault: Fault) -> Fault:
        """Return an empty list as an info where no node in C++ is shown to read its block.

        rclcpp converts the values of its own blocks alone.
        """
        if self.readers.is_idle(self.use.file.path, fault.span):
            return replace(fault, level="info")
        if self.level == "info" or ListReaders(self.use, self.readers).has(fault.span):
            return fault
        return softer_advice(fault, "info", UNSHOWN)
