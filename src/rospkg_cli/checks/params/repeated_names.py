"""PRM002: names that are twice in one mapping of a parameter file, or once with dots and once without."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import MappingNode, ScalarNode, YamlNode
from ...package.params.parameter_file import ParameterFile, below, is_key
from ...source import Span
from ..fault import Fault


def repetition_faults(file: ParameterFile) -> Iterator[Fault]:
    seen: set[Span] = set()
    for root in file.roots:
        for each in below(root):
            for fault in in_mapping(each) if isinstance(each, MappingNode) else ():
                seen.add(fault.span)
                yield fault
    for block in file.blocks:
        named: dict[str, ScalarNode] = {}
        for parameter in block.parameters:
            first = named.setdefault(parameter.name, parameter.key)
            if first is not parameter.key and parameter.key.span not in seen:
                yield repetition(parameter.key, first)


def in_mapping(mapping: MappingNode) -> Iterator[Fault]:
    named: dict[str, tuple[ScalarNode, YamlNode]] = {}
    for key, value in mapping.entries:
        if isinstance(key, ScalarNode) and not is_key(key):
            first, before = named.setdefault(key.text, (key, value))
            if first is not key:
                yield repetition(key, first, isinstance(value, MappingNode) and isinstance(before, MappingNode))


def repetition(key: ScalarNode, first: ScalarNode, are_joined: bool = False) -> Fault:
    """Return the fault of a name that is there before; where both hold mappings, rcl joins them."""
    related = ((first.span, "the first one"),)
    if are_joined:
        message = f"`{key.text}` is here twice: rcl joins both, PyYAML (launch files) has only the last"
        return Fault(key.span, message, "info", related=related)
    return Fault(key.span, f"`{key.text}` is here twice: the last value wins, without a warning", related=related)
