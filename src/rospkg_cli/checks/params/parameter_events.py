"""What code declares and gets of parameters, in the order in which it stands."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.cpp.file import CppFile
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.params.python_parameters import READS
from ...source import Span

TARGET = regex(r"([\w.>\[\]-]+)\s*=(?!=)[^=;{}]*$")
STATEMENT = regex(r"(?:^|[;{}:])\s*(?:this\s*->\s*|\w+\s*(?:->|\.)\s*)?$")
BEFORE = 200
CPP_TEXT = regex(r'"(?:[^"\\\n]|\\.)*"')
"""A text in quotes in C++."""


@dataclass(frozen=True, slots=True)
class Event:
    """A parameter that is declared, or one that is got."""

    name: str
    span: Span
    is_read: bool
    target: str
    """The variable that is set; for a declaration "" where its value is dropped."""


def events_in_cpp(file: CppFile) -> Iterator[Event]:
    text = file.source.text
    for call in file.calls:
        if call.name not in ("declare_parameter", *READS) or not call.arguments:
            continue
        first, *others = call.arguments
        before = text[max(0, call.span.start - BEFORE) : call.span.start]
        if call.name not in READS:
            yield Event(first.literal or "", call.span, False, "" if STATEMENT.search(before) else "used")
        else:
            set_to = TARGET.search(before)
            into = others[0].text if others else set_to.group(1) if set_to else ""
            yield Event(first.literal or "", first.span, True, into)


def events_in_python(file: PythonFile) -> Iterator[Event]:
    dropped = {id(each.value) for each in nodes_of_kind(file.tree, ast.Expr)}
    targets = {id(part): target for each in nodes_of_kind(file.tree, ast.Assign) for part, target in set_by(each)}
    for call in nodes_of_kind(file.tree, ast.Call):
        match call:
            case ast.Call(func=ast.Attribute(attr=method), args=[first, *_]):
                name = first.value if isinstance(first, ast.Constant) and isinstance(first.value, str) else ""
                if method == "declare_parameter":
                    yield Event(name, file.span(first), False, "" if id(call) in dropped else "used")
                elif method in READS:
                    yield Event(name, file.span(first), True, targets.get(id(call), ""))


def set_by(each: ast.Assign) -> Iterator[tuple[ast.Call, str]]:
    """Yield the calls in what a variable is set to, with the variable."""
    if len(each.targets) == 1:
        target = ast.unparse(each.targets[0])
        yield from ((call, target) for call in nodes_of_kind(each, ast.Call))
