"""Find the blocks of a parameter file, and what rcl_yaml_param_parser refuses in it, each fault at its place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from collections.abc import Sequence as Many

from ...languages.yaml.nodes import AliasNode, MappingNode, ScalarNode, SequenceNode, YamlNode
from ...source import Source, Span
from .file import KEY, Fault, Kind, NodeBlock, ParameterFile, Repetition, below, inside, is_unknown
from .names import joined, name_fault
from .value import type_of

MISSPELT = re.compile(r"_*ros_+param(?:eter)?s?_*|_*rosparameters?_*", re.IGNORECASE)
REFUSES = "rcl refuses the whole file, and the node does not start"


def judge(source: Source, roots: Many[YamlNode]) -> ParameterFile:
    """Read the documents of a parameter file."""
    found = Judge(source)
    for root in roots:
        if isinstance(root, MappingNode):
            found.nodes(root, [])
        else:
            found.fault(root.span, "a parameter file is a mapping: the name of a node, and `ros__parameters:` below")
    found.repetitions(roots)
    return ParameterFile(source, tuple(roots), tuple(found.blocks), tuple(found.faults), tuple(found.repeated))


def is_key(node: YamlNode) -> bool:
    """Return whether rcl takes it for `ros__parameters`: it compares the beginning only."""
    return isinstance(node, ScalarNode) and node.text.startswith(KEY)


def is_misspelt(node: YamlNode) -> bool:
    return isinstance(node, ScalarNode) and not is_key(node) and MISSPELT.fullmatch(node.text) is not None


def has_block(node: YamlNode) -> bool:
    return any(
        is_key(key) or is_misspelt(key)
        for each in below(node)
        if isinstance(each, MappingNode)
        for key, _ in each.entries
    )


class Judge:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.blocks: list[NodeBlock] = []
        self.faults: list[Fault] = []
        self.repeated: list[Repetition] = []

    def fault(self, span: Span, message: str, kind: Kind = "yaml", repair: str | None = None) -> None:
        self.faults.append(Fault(kind, span, message, repair))

    def nodes(self, mapping: MappingNode, above: list[ScalarNode]) -> None:
        """Read what stands above `ros__parameters`: namespaces and names of nodes."""
        block: NodeBlock | None = None
        for key, value in mapping.entries:
            if not isinstance(key, ScalarNode):
                self.fault(key.span, f"a key is the name of a node here; {REFUSES}")
            elif is_key(key) or (is_misspelt(key) and isinstance(value, MappingNode)):
                block = self.block(key, value, above, block)
            elif isinstance(value, MappingNode):
                self.node(key, value, above, block)
            else:
                self.stray(key, value, above)

    def block(
        self, key: ScalarNode, value: YamlNode, above: list[ScalarNode], before: NodeBlock | None
    ) -> NodeBlock | None:
        if not is_key(key):
            self.fault(key.span, f"`{key.text}` is written `{KEY}`, with two `_`; {REFUSES}", "key", KEY)
        if not above:
            self.fault(key.span, f"`{KEY}` needs the name of a node above it, or `/**:` for all; {REFUSES}")
            return None
        if before:
            self.fault(key.span, f"`{KEY}` stands twice for one node; {REFUSES}")
        name = joined([each.text for each in above])
        why = None if is_unknown(name) else name_fault(name)
        if why:
            self.fault(above[-1].span, f"{why}; {REFUSES}")
        found = NodeBlock(name, above[-1], value)
        self.blocks.append(found)
        if isinstance(value, MappingNode):
            self.values(value)
        elif isinstance(value, ScalarNode) and value.plain and not value.text:
            self.fault(key.span, f"`{KEY}` of `{name}` is empty; {REFUSES}: write `{KEY}: {{}}`, or remove the node")
        else:
            self.fault(value.span, f"below `{KEY}` stand parameters as `name: value`, nothing else")
        return found

    def node(self, key: ScalarNode, value: MappingNode, above: list[ScalarNode], block: NodeBlock | None) -> None:
        if block and value.entries:
            self.fault(key.span, f"`{key.text}` must stand above the `{KEY}` of `{block.key.text}`; {REFUSES}")
        elif has_block(value) or not any(isinstance(each, ScalarNode) for each in below(value)):
            self.nodes(value, [*above, key])
        else:
            message = f"the block of `{key.text}` has no `{KEY}:` above its values; {REFUSES}"
            self.faults.append(Fault("key", key.span, message, *self.indented(key, value)))

    def indented(self, key: ScalarNode, value: MappingNode) -> tuple[str, Span] | tuple[None, None]:
        """Return the block with `ros__parameters:` above it, and its span; nothing where it is in braces."""
        text, first = self.source.text, value.entries[0][0].span.start
        start = text.rfind("\n", 0, first) + 1
        if text[value.span.start] == "{" or text[start:first].strip() or start <= key.span.end:
            return None, None
        end = first + len(text[first : value.span.end].rstrip())
        indent = text[start:first]
        lines = text[start:end].split("\n")
        return "\n".join([f"{indent}{KEY}:", *(f"  {line}" if line.strip() else line for line in lines)]), Span(
            start, end
        )

    def stray(self, key: ScalarNode, value: YamlNode, above: list[ScalarNode]) -> None:
        if isinstance(value, AliasNode):
            self.fault(value.span, alias(value))
        elif isinstance(value, ScalarNode) and value.plain and not value.text:
            self.fault(key.span, f"nothing stands below `{key.text}`; {REFUSES}: remove it")
        else:
            where = f"the `{KEY}:` of `{above[-1].text}`" if above else f"a node and its `{KEY}:`"
            self.fault(key.span, f"the value of `{key.text}` stands outside of {where}; {REFUSES}")

    def values(self, mapping: MappingNode) -> None:
        for number, (key, value) in enumerate(mapping.entries):
            if not isinstance(key, ScalarNode) or not key.text:
                self.fault(key.span, f"a parameter needs a name; {REFUSES}")
            elif isinstance(value, AliasNode):
                self.fault(value.span, alias(value))
            elif isinstance(value, SequenceNode):
                self.items(key, value)
            elif isinstance(value, MappingNode) and value.entries:
                self.values(value)
            elif isinstance(value, MappingNode) and number + 1 < len(mapping.entries):
                message = f"rcl loses its place behind the empty mapping of `{key.text}`: what follows is refused"
                self.fault(value.span, f"{message} or gets a wrong name; remove it")
            elif isinstance(value, ScalarNode) and not value.text and not value.quoted:
                self.fault(key.span, f'`{key.text}` has no value; {REFUSES}: write one (`""` for an empty text)')

    def items(self, key: ScalarNode, value: SequenceNode) -> None:
        name = key.text
        if not value.items:
            message = f"rcl can't tell the type of the empty list `{name}`: a C++ node that declares parameters stops"
            self.fault(value.span, f'{message} with "No parameter value set"; leave `{name}` out')
            return None
        if only := inside(value):
            return self.values(only)
        types: dict[str, ScalarNode] = {}
        for item in value.items:
            if isinstance(item, AliasNode):
                return self.fault(item.span, alias(item))
            if isinstance(item, SequenceNode):
                return self.fault(item.span, f"a list inside the list `{name}`: rcl knows no such parameter")
            if isinstance(item, MappingNode):
                return self.fault(item.span, f"a mapping inside the list `{name}`: rcl knows no such parameter")
            if not item.text and not item.quoted:
                return self.fault(item.span, f"an entry of `{name}` has no value; {REFUSES}")
            if is_unknown(item.text):
                return None
            types.setdefault(type_of(item), item)
        if len(types) > 1:
            self.mixed(name, list(types.items()))
        return None

    def mixed(self, name: str, types: list[tuple[str, ScalarNode]]) -> None:
        (first, one), (second, other) = types[:2]
        message = f"`{name}` mixes {first} (`{one.text}`) and {second} (`{other.text}`)"
        hint = "; write the whole numbers with `.0`" if {first, second} == {"int", "double"} else ""
        quote = "; quote the texts" if "string" in (first, second) or "bool" in (first, second) else ""
        self.fault(other.span, f"{message}: all entries of a list have one type; {REFUSES}{hint or quote}")

    def repetitions(self, roots: Many[YamlNode]) -> None:
        """Find names that stand twice: in one mapping, or once with dots and once without."""
        for root in roots:
            for each in below(root):
                if isinstance(each, MappingNode):
                    self.repeated += in_mapping(each)
        again = {each.key.span for each in self.repeated}
        for block in self.blocks:
            named: dict[str, ScalarNode] = {}
            for parameter in block.parameters:
                first = named.setdefault(parameter.name, parameter.key)
                if first is not parameter.key and parameter.key.span not in again:
                    self.repeated.append(Repetition(parameter.key, first, False))


def in_mapping(mapping: MappingNode) -> Iterator[Repetition]:
    seen: dict[str, tuple[ScalarNode, YamlNode]] = {}
    for key, value in mapping.entries:
        if isinstance(key, ScalarNode) and not is_key(key):
            first, before = seen.setdefault(key.text, (key, value))
            if first is not key:
                yield Repetition(key, first, isinstance(value, MappingNode) and isinstance(before, MappingNode))


def alias(node: AliasNode) -> str:
    return f"rcl knows no aliases (`*{node.name}`): {REFUSES}; write the value out"
