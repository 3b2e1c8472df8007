"""A parameter file as rules see it: blocks of parameters by node, and what rcl refuses."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...source import Source, Span

KEY = "ros__parameters"

Kind = Literal["key", "yaml"]


@dataclass(frozen=True, slots=True)
class Fault:
    """Something that rcl refuses; `repair` replaces `repair_span`, or the span where that is None."""

    kind: Kind
    """`key`: a node's block without `ros__parameters`; `yaml`: everything else."""
    span: Span
    message: str
    repair: str | None = None
    repair_span: Span | None = None
    """Where something else than the span is to be replaced."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """One value of a node; `name` with dots."""

    name: str
    key: ScalarNode
    value: YamlNode


@dataclass(frozen=True)
class NodeBlock:
    """The parameters of one node, or of all nodes that its name fits."""

    name: str
    """As rcl puts it together: the keys above `ros__parameters`, with `/` between them."""
    key: ScalarNode
    """The last of these keys."""
    value: YamlNode
    """Below `ros__parameters`."""

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        return tuple(flatten(self.value, "", 0))


@dataclass(frozen=True, slots=True)
class Repetition:
    key: ScalarNode
    first: ScalarNode
    """The key of the same name that stands before."""
    joined: bool
    """Both hold a mapping, and rcl makes one of them."""


@dataclass(frozen=True)
class ParameterFile:
    source: Source
    roots: tuple[YamlNode, ...]
    blocks: tuple[NodeBlock, ...]
    faults: tuple[Fault, ...] = ()
    repeated: tuple[Repetition, ...] = ()

    @property
    def path(self) -> str:
        return self.source.path


def flatten(node: YamlNode, prefix: str, depth: int) -> Iterator[Parameter]:
    """Yield the parameters of a mapping and of those inside it."""
    if not isinstance(node, MappingNode):
        return
    for key, value in node.entries:
        if not isinstance(key, ScalarNode):
            continue
        name = prefix + key.text
        if isinstance(value, SequenceNode):
            value = inside(value) or value
        if isinstance(value, MappingNode):
            yield from flatten(value, name + ".", depth + 1)
        else:
            yield Parameter(name, key, value)


def inside(items: SequenceNode) -> MappingNode | None:
    """Return the one mapping of a list that rcl does not see the list around: `[{interfaces: [a, b]}]`."""
    only = items.items[0] if len(items.items) == 1 else None
    if not isinstance(only, MappingNode) or not only.entries:
        return None
    return only if len(only.entries) == 1 or all(isinstance(value, SequenceNode) for _, value in only.entries) else None


def below(node: YamlNode) -> Iterator[YamlNode]:
    """Yield a node and all below it, in order, without recursion."""
    waiting = [node]
    while waiting:
        each = waiting.pop()
        yield each
        if isinstance(each, SequenceNode):
            waiting += reversed(each.items)
        elif isinstance(each, MappingNode):
            waiting += [part for entry in reversed(each.entries) for part in reversed(entry)]


def is_unknown(text: str) -> bool:
    """Return whether a text is filled in before rcl sees it: launch substitutions, templates."""
    return any(sign in text for sign in ("$(", "${", "{{", "{%", "<%", "@("))
