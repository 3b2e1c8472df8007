"""What one text of code says of the names of its nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass

COMMENT = regex(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
IN_CPP = regex(
    r"(?<![\w~])(?:Lifecycle)?Node(?:\s*>)?(?:\s*::\s*make_shared)?\s*(?:\(\s*(\"\w*\"|[^)\s])|\{\s*(\"\w*\"))"
)
"""A call of a constructor of a node, with its first argument."""
OWN_CLASS = regex(r"[:,]\s*(?:\w+::)*(?:Lifecycle)?Node\s*[({]\s*\"")
"""A class that hands its base class the name."""
MAIN = regex(r"\bint\s+main\s*\(")
MADE = regex(r"(?:make_(?:shared|unique)\s*<|\bnew\b)\s*(?!rclcpp::(?:Node|executors)\b)([\w:]+)")
"""An object that may be a node, with its class."""
IN_PYTHON = regex(
    r"(?:super\([^)\n]*\)\.__init__|\bNode\.__init__|\bcreate_node|\bNode)"
    r"\(\s*(?:self\s*,\s*)?(?:node_name\s*=\s*)?(['\"]\w*['\"]|[^\s'\")]|\))"
)
NODE_CLASS = regex(r"\bclass\s+\w+\s*\([^)]*Node\s*[,)]|\bcreate_node\s*\(|\brclpy\.node\.Node\s*\(")
INCLUDED = regex(r'#[ \t]*include[ \t]*["<]([^">\n]+)[">]')
OPTIONS = regex(r"__node\b|__name\b")
"""Arguments of a node by which code renames it."""
IN_LINE = regex(r"(?m)^[ \t]*#[^\n]*")


@dataclass(frozen=True, slots=True)
class NodeText:
    names: frozenset[str]
    """Those that it gives its nodes; "" for one that is computed."""
    made: frozenset[str] = frozenset()
    """The classes of objects that a program makes and that may be nodes."""
    is_own: bool = False
    """Whether a class of it hands its base class the name."""
    included: tuple[str, ...] = ()


def of_cpp(text: str) -> NodeText:
    code = COMMENT.sub(lambda each: each[0] if each[0][0] == '"' else " ", text)
    made = frozenset(found[1] for found in MADE.finditer(code)) if MAIN.search(code) else frozenset[str]()
    is_own = OWN_CLASS.search(code) is not None
    return NodeText(frozenset(names_in(code)), made, is_own, tuple(INCLUDED.findall(code)))


def of_python(text: str) -> NodeText:
    code = IN_LINE.sub("", text)
    return NodeText(frozenset(names_in(code, is_python=True)))


def names_in(text: str, *, is_python: bool = False) -> Iterator[str]:
    """Yield the names of the nodes that a text makes; "" for one that is computed."""
    if is_python and not NODE_CLASS.search(text):
        return
    if OPTIONS.search(text):
        yield ""
    for found in (IN_PYTHON if is_python else IN_CPP).finditer(text):
        name = found[found.lastindex or 1]
        yield name[1:-1] if name[0] in "'\"" else ""
