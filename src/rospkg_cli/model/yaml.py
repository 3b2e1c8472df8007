"""YAML as a tree with spans, by libyaml; its marks count characters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from ..source import Source, Span
from .unreadable import UnreadableError
from .written import Written

MAX_DEPTH = 100
MAX_NODES = 100_000
"""Aliases may make a small text large."""


@dataclass(frozen=True, slots=True)
class Leaf:
    text: str
    span: Span
    """Between the quotes where there are any."""
    exact: bool

    @property
    def written(self) -> Written:
        return Written(self.text, self.span, self.exact)


@dataclass(frozen=True, slots=True)
class Branch:
    """A mapping, or a sequence (whose keys say nothing)."""

    kind: Literal["mapping", "sequence"]
    span: Span
    items: tuple[tuple[Leaf, Tree], ...]


Tree = Leaf | Branch


def compose(source: Source) -> Tree | None:
    """Return the tree of the first document; raises UnreadableError for what is not YAML."""
    import yaml  # 22 ms that a package without YAML need not pay

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        node = yaml.compose(source.text, Loader=loader)
    except yaml.YAMLError as error:
        raise not_yaml(source, error) from None
    return None if node is None else Builder(source).tree(node, 0)


def not_yaml(source: Source, error: Any) -> UnreadableError:
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    at = min(mark.index if mark else 0, len(source.text))
    said = getattr(error, "problem", None) or str(error).split("\n", 1)[0]
    return UnreadableError(source.path, Span(at, min(at + 1, len(source.text))), f"`{source.path}` is not YAML: {said}")


class Builder:
    """Makes the tree of libyaml's nodes."""

    def __init__(self, source: Source) -> None:
        self.source, self.count = source, 0

    def tree(self, node: Any, depth: int) -> Tree:
        """Raises UnreadableError for what is too deep or too large."""
        span, self.count = Span(node.start_mark.index, node.end_mark.index), self.count + 1
        if depth > MAX_DEPTH or self.count > MAX_NODES:
            raise UnreadableError(self.source.path, span, f"`{self.source.path}` is nested too deeply, or too large")
        if node.id == "scalar":
            if node.style in ("'", '"'):
                span = Span(span.start + 1, span.end - 1)
            return Leaf(node.value, span, self.source.slice(span) == node.value)
        if node.id == "sequence":
            none = Leaf("", span, False)
            return Branch("sequence", span, tuple((none, self.tree(item, depth + 1)) for item in node.value))
        items = [(self.tree(key, depth + 1), self.tree(value, depth + 1)) for key, value in node.value]
        return Branch("mapping", span, tuple((key, value) for key, value in items if isinstance(key, Leaf)))
