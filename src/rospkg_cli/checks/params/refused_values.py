"""Rule input: a parameter file with what rcl refuses in it, and the nodes that would stop at that (PRM001, PRM004)."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ..fault import Fault, Level, softer_advice
from .block_readers import BlockReaders
from .list_readers import UNSHOWN, ListReaders
from .parameter_file_use import REWRITES, ParameterFileUse

ALIAS = regex(r"rcl does not support aliases \(`\*([^`]+)`\)")


@dataclass(frozen=True)
class RefusedValues:
    use: ParameterFileUse
    readers: BlockReaders

    @property
    def level(self) -> Level | None:
        """The level of what rcl refuses: an info where only nodes that nobody starts are given the file."""
        return "info" if self.readers.is_unopened(self.use.file) else self.use.level

    @property
    def level_in_rcl(self) -> Level | None:
        """The same of what PyYAML reads: an info where launch files give the file to components alone."""
        given = self.readers.given(self.use.file)
        is_for_components = bool(given) and all(each.node.kind == "composable_node" for each in given)
        return "info" if is_for_components and not self.use.is_handed else self.level

    def is_resolved(self, fault: Fault) -> bool:
        """Return whether a fault is an alias of one value, which a launch file writes out (RewrittenYaml)."""
        file, found = self.use.file, ALIAS.match(fault.message)
        name = file.path.rpartition("/")[2]
        is_rewritten = any(name in text and f"{REWRITES}(" in text for text in self.use.rewriting)
        if found is None or self.use.is_handed or not is_rewritten:
            return False
        anchor = re.search(rf"&{re.escape(found[1])}[ \t]+[^\s\[{{|>&*!#]", file.source.text)
        return anchor is not None and not re.match(r"[^\n#]*:(?:\s|$)", file.source.text[anchor.end() - 1 :])

    def at_its_level(self, fault: Fault) -> Fault:
        """Return an empty list as an info where no node in C++ is shown to read its block.

        rclcpp converts the values of its own blocks alone.
        """
        if self.readers.is_idle(self.use.file.path, fault.span):
            return replace(fault, level="info")
        if self.level == "info" or ListReaders(self.use, self.readers).has(fault.span):
            return fault
        return softer_advice(fault, "info", UNSHOWN)
