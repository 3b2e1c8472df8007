"""PRM002: names that are twice in one mapping of a parameter file, or once with dots and once without."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...light_dataclasses import dataclass, replace
from ...package.params.node_entries import below, is_key
from ...package.params.parameter_file import Parameter, ParameterFile
from ...package.params.scalar_types import TRUE, type_of
from ...source import Span
from ...unreadable import READABLE
from ..fault import Fault
from .block_readers import BlockReaders


@dataclass(frozen=True)
class ParameterFiles:
    """All parameter files of a package, and what is known of those that read them (PRM002)."""

    files: Annotated[tuple[ParameterFile, ...], READABLE]
    readers: BlockReaders

    def faults(self, file: ParameterFile) -> Iterator[Fault]:
        """Yield what is twice in a file; where no node reads it, an info."""
        for fault in repetition_faults(file):
            yield replace(fault, level="info") if self.readers.is_idle(file.path, fault.span) else fault


def repetition_faults(file: ParameterFile) -> Iterator[Fault]:
    seen: set[Span] = set()
    for root in file.roots:
        for each in below(root):
            for fault in in_mapping(each) if isinstance(each, MappingNode) else ():
                seen.add(fault.span)
                yield fault
    for block in file.blocks:
        named: dict[str, Parameter] = {}
        for parameter in block.parameters:
            first = named.setdefault(parameter.name, parameter)
            if first is not parameter and parameter.key.span not in seen:
                yield repetition(parameter.key, first.key, (parameter.value, first.value))


def in_mapping(mapping: MappingNode) -> Iterator[Fault]:
    named: dict[str, tuple[ScalarNode, YamlNode]] = {}
    for key, value in mapping.entries:
        if isinstance(key, ScalarNode) and not is_key(key):
            first, before = named.setdefault(key.text, (key, value))
            if first is not key:
                yield repetition(key, first, (value, before))


def repetition(key: ScalarNode, first: ScalarNode, values: tuple[YamlNode, YamlNode]) -> Fault:
    """Return the fault of a name that is there before; where both hold mappings, rcl joins them."""
    related = ((first.span, "the first one"),)
    if all(isinstance(value, MappingNode) for value in values):
        message = f"`{key.text}` is here twice: rcl joins both, PyYAML (launch files) has only the last; write one"
        return Fault(key.span, message, "info", related=related)
    if are_equal(*values):
        return Fault(key.span, f"`{key.text}` is here twice, with one value: remove one", "info", related=related)
    return Fault(
        key.span, f"`{key.text}` is here twice: the last value wins, without a warning; remove one", related=related
    )


def are_equal(one: YamlNode, other: YamlNode) -> bool:
    """Return whether two scalars or lists have one value and type."""
    if isinstance(one, ScalarNode) and isinstance(other, ScalarNode):
        return type_of(one) == type_of(other) and (one.text == other.text or are_equal_truths(one, other))
    if isinstance(one, SequenceNode) and isinstance(other, SequenceNode) and len(one.items) == len(other.items):
        return all(map(are_equal, one.items, other.items))
    return False


def are_equal_truths(one: ScalarNode, other: ScalarNode) -> bool:
    """Return whether two booleans are the same, as `False` and `false` are."""
    return type_of(one) == type_of(other) == "bool" and (one.text in TRUE) is (other.text in TRUE)
