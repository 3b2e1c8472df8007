"""PRM004: what rcl_yaml_param_parser refuses in a parameter file, but for `ros__parameters` itself (PRM001).

Sources: ros2/rcl: parse.c (also _validate_name) and rmw_validate_namespace; ros2/rclcpp: parameter_map.cpp.
"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import AliasNode, MappingNode, ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...package.params.parameter_file import (
    KEY,
    NodeEntry,
    ParameterFile,
    has_placeholder,
    mapping_in_list,
    node_name,
)
from ...package.params.scalar_types import type_of
from ..fault import Fault
from .lists_in_rcl import takes_list

REFUSES = "rcl refuses the file, and the node does not start"
EMPTY_LIST = "rcl can't determine the type of the empty list"
"""What rcl accepts, and only a node in C++ stops at."""
NAME = regex(r"[A-Za-z_][A-Za-z0-9_]*")
WILDCARDS = ("*", "**")
PLACEHOLDER = regex(r"<\w+>")
"""What a program writes something else for, before rcl reads the file: `<robot_namespace>`."""
MAX_NAME = 255


def rcl_faults(file: ParameterFile) -> Iterator[Fault]:
    for root in file.roots:
        if not isinstance(root, MappingNode):
            yield Fault(root.span, "a parameter file is a mapping: the name of a node, and `ros__parameters:` below")
    outside = {entry.above for entry in file.entries if is_outside(entry)}
    for entry in file.entries:
        key, value = entry.key, entry.value
        if not isinstance(key, ScalarNode):
            yield Fault(key.span, f"a key is the name of a node here; {REFUSES}")
        elif entry.kind == "block":
            is_told = is_empty(value) and entry.above in outside  # its values stand beside it
            yield from () if is_told else block_faults(key, value, entry)
        elif entry.kind == "after block":
            node = entry.above[-1].text
            yield Fault(key.span, f"`{key.text}` must come before the `{KEY}` of `{node}`; {REFUSES}")
        elif entry.kind == "value" and (isinstance(value, AliasNode) or is_empty(value)):
            yield alias_fault(value) if isinstance(value, AliasNode) else no_value(key)
    yield from misplaced_values(file)


def block_faults(key: ScalarNode, value: YamlNode, entry: NodeEntry) -> Iterator[Fault]:
    """Yield what is wrong with `ros__parameters`, with the name of its node, and with its values."""
    if not entry.above:
        yield Fault(key.span, f"`{KEY}` needs the name of a node above it, or `/**:` for all; {REFUSES}")
        return
    if entry.is_after_block:
        yield Fault(key.span, f"`{KEY}` is there twice for one node; {REFUSES}")
    name = node_name(entry.above)
    why = None if has_placeholder(name) else name_problem(name)
    if why:
        yield Fault(entry.above[-1].span, f"{why}; {REFUSES}")
    if isinstance(value, MappingNode):
        yield from value_faults(value)
    elif is_empty(value):
        message = f"`{KEY}` of `{name}` is empty; {REFUSES}: write `{KEY}: {{}}`, or remove the node"
        yield Fault(key.span, message)
    else:
        yield Fault(value.span, f"the value of `{KEY}` is a mapping of parameters, `name: value`")


def is_empty(value: YamlNode) -> bool:
    return isinstance(value, ScalarNode) and value.is_plain and not value.text


def name_problem(name: str) -> str | None:
    """Return why rcl refuses the name of a node with its namespace; None where it does not."""
    if name in ("/**", "/*"):
        return None
    namespace, slash, node = name.rpartition("/")
    if not node:
        return f"`{name}` ends with `/` instead of the name of a node"
    has_empty = slash and "" in namespace.removeprefix("/").split("/") and namespace not in ("", "/")
    if has_empty or name.startswith("//"):
        return f"`{name}` has two `/` in a row"
    for part in (*namespace.split("/"), node):
        if PLACEHOLDER.fullmatch(part):
            return None
        if part and part not in WILDCARDS and not NAME.fullmatch(part):
            return f"`{part}` is no name of a node or namespace: letters, digits and `_`, no digit first"
    return f"`{node[:20]}…` is longer than {MAX_NAME} characters" if len(node) > MAX_NAME else None


def no_value(key: ScalarNode) -> Fault:
    return Fault(key.span, f"`{key.text}` has no value; {REFUSES}: remove it")


def is_outside(entry: NodeEntry) -> bool:
    """Return whether an entry is a parameter that stands above the parameters."""
    return entry.kind == "value" and not isinstance(entry.value, AliasNode) and not is_empty(entry.value)


def misplaced_values(file: ParameterFile) -> Iterator[Fault]:
    """Yield one fault for all values of a node, or of none, that belong below a `ros__parameters`."""
    outside: dict[str, list[ScalarNode]] = {}
    for entry in file.entries:
        if is_outside(entry) and isinstance(entry.key, ScalarNode):
            where = f"the `{KEY}:` of `{entry.above[-1].text}`" if entry.above else f"a node and its `{KEY}:`"
            outside.setdefault(where, []).append(entry.key)
    for where, (first, *others) in outside.items():
        name = f"`{first.text}`"
        what = f"the values of {name} and {len(others)} more are" if others else f"the value of {name} is"
        them = "them" if others else "it"
        todo = f"put {them} below one" if where.startswith("a node") else f"indent {them}"
        message = f"{what} outside of {where}; {REFUSES}: {todo}"
        yield Fault(first.span, message, related=tuple((each.span, "and this one") for each in others))


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
