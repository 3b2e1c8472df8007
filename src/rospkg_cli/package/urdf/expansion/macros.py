"""Macros of xacro, and how their parameters are written. (xacro/__init__.py: parse_macro_arg)"""

from __future__ import annotations

import re

from ....languages.xml.parser import Element
from ....lazy_regex import regex
from ....light_dataclasses import dataclass
from ....source import Source

VALUE = r"""\$\{.*?\}|\$\(.*?\)|(?:'.*?'|".*?"|[^\s'"]+)+|"""
WITH_DEFAULT = regex(rf"\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?({VALUE})(?:\s+|$)(.*)", re.DOTALL)


@dataclass(frozen=True, slots=True)
class MacroParameter:
    name: str
    """With its `*` or `**`, where it takes a block."""
    default: str | None = None
    is_forwarded: bool = False
    """Whether the caller's property of this name is its default: `name:=^`."""

    @property
    def is_block(self) -> bool:
        return self.name.startswith("*")

    @property
    def is_required(self) -> bool:
        return self.default is None and not self.is_forwarded


@dataclass(frozen=True, slots=True, eq=False)
class Macro:
    name: str
    parameters: tuple[MacroParameter, ...]
    element: Element
    source: Source
    is_certain: bool
    """False where it is defined under an unknown condition, perhaps several times."""


def macro_name(element: Element) -> str:
    return (element.get("name") or "").removeprefix("xacro:")


def parameters_of(text: str) -> tuple[MacroParameter, ...]:
    """Return the parameters of `params="a b:=1 c:=^ d:=^|2 *block **blocks"`."""
    found = []
    rest = text.strip()
    while rest:
        match = WITH_DEFAULT.match(rest)
        if match is None:
            name, *more = rest.split(None, 1)
            rest = more[0] if more else ""
            found.append(MacroParameter(name))
            continue
        name, forward, default, rest = match.groups()
        found.append(MacroParameter(name, default or None, bool(forward)))
    return tuple(found)
