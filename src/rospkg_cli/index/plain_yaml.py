"""YAML of strangers as plain values: built from libyaml's events, without recursion and within bounds.

PyYAML's own loaders recurse (100,000 `[` end the process with a signal) and copy what merge keys name, again and again.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

MAX_DEPTH = 50
"""rosdep's lists have six levels, distribution files five."""

TOO_DEEP = f"it is nested deeper than {MAX_DEPTH} levels"
LIBYAML_DEPTH = "exceeded maximum nesting depth"
"""What libyaml says since 0.2.6, of 1,000 levels: it looks ahead, so that it may be the first to see them."""

MAX_VALUES = 1_000_000
"""Scalars, lists and mappings with all that aliases stand for; the largest of rosdistro's files has about 60,000."""

MAX_DIGITS = 100
"""Of a number or a date; reading a longer one takes time that grows with its square."""

MERGE = "tag:yaml.org,2002:merge"
COLLECTIONS = {"tag:yaml.org,2002:seq": list, "tag:yaml.org,2002:map": dict}


class YamlError(ValueError):
    """A text that is no YAML, or more than is read; `line` is the first that is wrong, from 1."""

    def __init__(self, problem: str, line: int | None = None, is_syntax: bool = False) -> None:
        super().__init__(problem)
        self.line = line
        self.is_syntax = is_syntax


class Open:
    """A list or a mapping whose end has not come."""

    def __init__(self, tag: str | None, kind: type, anchor: str | None, before: int) -> None:
        if tag not in (None, "!") and COLLECTIONS.get(str(tag)) is not kind:
            raise YamlError(f"it has a tag `{tag}`")
        self.value: Any = kind()
        self.anchor = anchor
        self.before = before
        """How many values there were before it."""
        self.key: Any = None
        self.has_key = False
        self.merged: dict[Any, Any] = {}

    def put(self, value: Any, is_merge: bool) -> int:
        """Take an item, a key or the value of one; return how many values were copied."""
        if isinstance(self.value, list):
            self.value.append(value)
        elif not self.has_key:
            if isinstance(value, list | dict):
                raise YamlError("a key is a list or a mapping")
            self.key, self.has_key = (MERGE if is_merge else value), True
        else:
            self.has_key = False
            if self.key is MERGE:
                return self.merge(value)
            self.value[self.key] = value
        return 0

    def merge(self, value: Any) -> int:
        sources = value if isinstance(value, list) else [value]
        if not all(isinstance(each, dict) for each in sources):
            raise YamlError("what is merged is no mapping")
        for each in sources:  # the first one that has a key gives its value
            self.merged = {**each, **self.merged}
        return sum(map(len, sources))

    def ended(self) -> Any:
        if self.merged:  # its own keys win; in place, for an alias may stand for it
            self.value = {**self.merged, **self.value}
        return self.value


class PlainBuilder:
    """Puts events together; every bound is on the sum, so that no form of them can be made to grow."""

    def __init__(self) -> None:
        import yaml

        self.scalars: Any = yaml.SafeLoader("")
        self.open: list[Open] = []
        self.anchored: dict[str, tuple[Any, int]] = {}
        self.count = 0
        self.roots: list[Any] = []

    def take(self, event: Any) -> None:
        name = type(event).__name__
        if name == "ScalarEvent":
            self.add(1)
            value, is_merge = self.scalar(event)
            self.put(value, event.anchor, 1, is_merge)
        elif name == "AliasEvent":
            if event.anchor not in self.anchored:
                raise YamlError(f"`*{event.anchor}` stands for nothing before it")
            value, size = self.anchored[event.anchor]
            self.add(size)
            self.put(value, None, size, False)
        elif name in ("SequenceStartEvent", "MappingStartEvent"):
            if len(self.open) >= MAX_DEPTH:
                raise YamlError(TOO_DEEP)
            kind = list if name == "SequenceStartEvent" else dict
            self.open.append(Open(event.tag, kind, event.anchor, self.count))
            self.add(1)
        elif name in ("SequenceEndEvent", "MappingEndEvent"):
            one = self.open.pop()
            self.put(one.ended(), one.anchor, self.count - one.before, False)

    def add(self, count: int) -> None:
        self.count += count
        if self.count > MAX_VALUES:
            raise YamlError(f"it has more than {MAX_VALUES:,} values, with what aliases stand for")

    def put(self, value: Any, anchor: str | None, size: int, is_merge: bool) -> None:
        if anchor is not None:
            self.anchored[anchor] = (value, size)
        if self.open:
            self.add(self.open[-1].put(value, is_merge))
        elif self.roots:
            raise YamlError("it holds several documents")
        else:
            self.roots.append(value)

    def scalar(self, event: Any) -> tuple[Any, bool]:
        """Return what a scalar stands for by YAML 1.1, and whether it is the key `<<`."""
        import yaml

        tag = event.tag
        if tag in (None, "!"):
            tag = self.scalars.resolve(yaml.ScalarNode, event.value, event.implicit)
        if tag == "tag:yaml.org,2002:str":
            return event.value, False
        if tag == MERGE:
            return event.value, True
        if len(event.value) > MAX_DIGITS:
            raise YamlError(f"a number or a date has {len(event.value)} characters")
        node = yaml.ScalarNode(tag, event.value, event.start_mark, event.end_mark)
        return self.scalars.construct_object(node), False


def plain_yaml(data: bytes) -> Any:
    """Return what a YAML file of one document holds, None for nothing; raises YamlError."""
    import yaml

    builder, event = PlainBuilder(), None
    try:
        for event in events(data):
            builder.take(event)
    except YamlError as error:
        mark = getattr(event, "start_mark", None)
        raise YamlError(str(error), mark.line + 1 if mark else None) from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        if getattr(error, "problem", "") == LIBYAML_DEPTH:
            raise YamlError(TOO_DEEP, mark.line + 1 if mark else None) from None
        raise YamlError("it is not YAML", mark.line + 1 if mark else None, is_syntax=True) from None
    except (ArithmeticError, LookupError, TypeError, ValueError):  # dates and numbers that are none
        raise YamlError("it is not YAML", event.start_mark.line + 1 if event else None, is_syntax=True) from None
    return builder.roots[0] if builder.roots else None


def events(data: bytes) -> Iterator[Any]:
    import yaml

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    return iter(yaml.parse(data, Loader=loader))
