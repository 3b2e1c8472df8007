"""Values of parameters that rcl_yaml_param_parser refuses: aliases, lists of several types, missing values (PRM004)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import AliasNode, MappingNode, ScalarNode, SequenceNode, YamlNode
from ...package.params.parameter_file import has_placeholder, mapping_in_list
from ...package.params.scalar_types import type_of
from ..fault import Fault
from .lists_in_rcl import takes_list

REFUSES = "rcl refuses the file, and the node does not start"
EMPTY_LIST = "rcl can't determine the type of the empty list"
"""What rcl accepts, and only a node in C++ stops at."""


def value_faults(mapping: MappingNode) -> Iterator[Fault]:
    """Yield what is wrong with the parameters of a mapping and of those inside it."""
    for number, (key, value) in enumerate(mapping.entries):
        if not isinstance(key, ScalarNode) or not key.text:
            yield Fault(key.span, f"a parameter needs a name; {REFUSES}")
        elif isinstance(value, AliasNode):
            yield alias_fault(value)
        elif isinstance(value, SequenceNode):
            yield from list_faults(key.text, value)
        elif isinstance(value, MappingNode) and value.entries:
            yield from value_faults(value)
        elif isinstance(value, MappingNode) and number + 1 < len(mapping.entries):
            message = f"behind the empty mapping of `{key.text}` rcl refuses what follows, or gives it a wrong name"
            yield Fault(value.span, f"{message}; remove it")
        elif isinstance(value, ScalarNode) and not value.text and not value.is_quoted:
            message = f'`{key.text}` has no value; {REFUSES}: write one (`""` for an empty string)'
            yield Fault(key.span, message)


def list_faults(name: str, value: SequenceNode) -> Iterator[Fault]:
    """Yield what is wrong with a list: the first item that rcl can't read, or items of several types."""
    if not value.items:
        message = f"{EMPTY_LIST} `{name}`: a C++ node stops"
        yield Fault(value.span, f'{message} with "No parameter value set"; leave `{name}` out', "warning")
        return
    if only := mapping_in_list(value):
        yield from value_faults(only)
        return
    types: dict[str, ScalarNode] = {}
    for item in value.items:
        if isinstance(item, SequenceNode) and item is value.items[-1]:
            return  # rcl takes what it holds for the list's own entries
        if not isinstance(item, ScalarNode) or (not item.text and not item.is_quoted):
            is_lost = isinstance(item, MappingNode) and takes_list(value)
            yield lost_list(name, item) if is_lost else item_fault(name, item)
            return
        if has_placeholder(item.text):
            return
        types.setdefault(type_of(item), item)
    if len(types) > 1:
        yield mixed_types(name, list(types.items()))


def item_fault(name: str, item: YamlNode) -> Fault:
    if isinstance(item, AliasNode):
        return alias_fault(item)
    if isinstance(item, ScalarNode):
        return Fault(item.span, f"an entry of `{name}` has no value; {REFUSES}")
    kind = "list" if isinstance(item, SequenceNode) else "mapping"
    return Fault(item.span, f"a {kind} inside the list `{name}`; {REFUSES}")


def lost_list(name: str, item: YamlNode) -> Fault:
    """Return the fault of a list that rcl reads to its end, and puts below a name that no node asks for."""
    message = f"rcl drops the mapping inside the list `{name}`: what it holds gets another name"
    return Fault(item.span, f"{message}, and the node finds no `{name}`", "warning")


def mixed_types(name: str, types: list[tuple[str, ScalarNode]]) -> Fault:
    (first, one), (second, other) = types[:2]
    message = f"`{name}` mixes {first} (`{one.text}`) and {second} (`{other.text}`)"
    hint = "; write the whole numbers with `.0`" if {first, second} == {"int", "double"} else ""
    quote = "; quote the strings" if "string" in (first, second) or "bool" in (first, second) else ""
    return Fault(other.span, f"{message}: {REFUSES}{hint or quote}")


def alias_fault(node: AliasNode) -> Fault:
    return Fault(node.span, f"rcl does not support aliases (`*{node.name}`): {REFUSES}; write the value out")
