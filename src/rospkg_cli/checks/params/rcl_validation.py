"""PRM004: what rcl_yaml_param_parser refuses in a parameter file, but for `ros__parameters` itself (PRM001).

Sources: ros2/rcl: parse.c (also _validate_name) and rmw_validate_namespace; ros2/rclcpp: parameter_map.cpp.
"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import AliasNode, MappingNode, ScalarNode, YamlNode
from ...lazy_regex import regex
from ...package.params.node_entries import KEY, NodeEntry, node_name
from ...package.params.parameter_file import ParameterFile, has_placeholder
from ..fault import Fault
from .rcl_values import REFUSES, alias_fault, value_faults

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
            is_reported = is_empty(value) and entry.above in outside  # with its values, which stand at the same depth
            yield from () if is_reported else block_faults(key, value, entry)
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
