"""What rcl makes of a list that has mappings in it: it reads their keys and values one after the other."""

from __future__ import annotations

from ...languages.yaml.nodes import AliasNode, MappingNode, ScalarNode, SequenceNode, YamlNode
from ...package.params.parameter_file import has_placeholder
from ...package.params.scalar_types import type_of


def takes_list(value: SequenceNode) -> bool:
    """Return whether rcl reads a list with mappings in it to its end, and gives what it holds a name of its own."""
    reading = ListReading()
    waiting: list[YamlNode | None] = [*reversed(value.items)]
    while waiting:
        node = waiting.pop()
        if node is None:
            reading.end_list()
        elif not reading.takes(node):
            return False
        elif isinstance(node, SequenceNode):
            waiting += [None, *reversed(node.items)]
        elif isinstance(node, MappingNode):
            waiting += [part for entry in reversed(node.entries) for part in reversed(entry)]
    return True


class ListReading:
    """What parse_file_events() of rcl_yaml_param_parser keeps between the events within a list."""

    def __init__(self) -> None:
        self.is_key = False
        self.is_list = True
        self.type = ""
        """Of the values of the list so far, "" before the first."""

    def end_list(self) -> None:
        self.is_list, self.is_key = False, True

    def takes(self, node: YamlNode) -> bool:
        """Return whether rcl reads on after a scalar, or after the beginning of a list or mapping.

        Behind the first key of a mapping within a list, the next ones are values for it.
        """
        if isinstance(node, MappingNode):
            self.is_key = True
            return bool(node.entries) and all(isinstance(key, ScalarNode) for key, _ in node.entries)
        if isinstance(node, SequenceNode):
            self.is_list, self.type = True, ""
            return not self.is_key
        return not isinstance(node, AliasNode) and self.takes_scalar(node)

    def takes_scalar(self, node: ScalarNode) -> bool:
        if not node.text and (self.is_key or not node.is_quoted):
            return False
        if self.is_key:
            self.is_key = False
            return True
        if not self.is_list:
            self.is_key = True
            return True
        found = self.type if has_placeholder(node.text) else type_of(node)
        first, self.type = self.type or found, self.type or found
        return found == first
