"""Python expressions in launch files (`PythonExpression`, `$(eval …)`), as Python would read their text."""

from __future__ import annotations

import ast
import builtins
import math
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from ...package.launch.file import LaunchFile
from ...package.launch.text import LaunchText, Literal, Substitution
from ...source import Span

STANDINS = ("a", "0", "a.b", "")
"""What may stand in the place of a text that only the launch knows."""

KNOWN = frozenset(dir(builtins)) | frozenset(vars(math)) | {"math"}
MAX_TEXT = 4000


@dataclass(frozen=True, slots=True)
class BadExpression:
    span: Span
    text: str
    """As Python gets it; `…` for what is not known."""
    why: str
    name: str = ""
    """The name that Python does not know, where there is one."""
    by_default: bool = False
    """Whether the default of an argument brings that name."""


def bad_expressions(found: Substitution, defaults: Mapping[str, str]) -> Iterator[BadExpression]:
    """Yield what is wrong with one expression, given the defaults of the file's arguments."""
    if not found.arguments or len(found.arguments) > 1:
        return
    expression = found.arguments[0]
    if any(isinstance(part, Substitution) and part.name in ("?", "eval") for part in expression.parts):
        return
    shown = filled(expression, "…", {})
    if len(shown) > MAX_TEXT:
        return
    if all(parsed(filled(expression, each, {})) is None for each in STANDINS):
        yield BadExpression(found.span, shown, "is no Python expression: launch stops with SyntaxError")
        return
    usual = filled(expression, None, defaults)
    tree = parsed(usual) if usual is not None else None
    if tree is not None and usual is not None:
        for name in unknown_names(tree):
            brought = not any(name in part.text for part in expression.parts if isinstance(part, Literal))
            yield BadExpression(found.span, usual, f"asks for `{name}`: launch stops with NameError", name, brought)


def filled(text: LaunchText, standin: str | None, defaults: Mapping[str, str]) -> str:
    """Return the text with every substitution replaced; by the default of an argument where there is one."""
    parts = []
    for part in text.parts:
        if isinstance(part, Literal):
            parts.append(part.text)
            continue
        name = part.arguments[0].literal if part.name == "var" and part.arguments else None
        parts.append(defaults.get(name or "", standin if standin is not None else "0"))
    return "".join(parts)


def parsed(text: str) -> ast.Expression | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def unknown_names(tree: ast.Expression) -> Iterator[str]:
    """Yield the names that nothing gives a meaning, each once."""
    bound = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    bound |= {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    used = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load))
    yield from (name for name in dict.fromkeys(used) if name not in bound | KNOWN)


def expression_faults(file: LaunchFile) -> Iterator[BadExpression]:
    """Yield the bad expressions of a file, with the defaults of its own arguments filled in."""
    assigned = {text.literal for text in file.assigned}
    defaults: dict[str, str] = {}
    for argument in file.arguments:
        name, default = argument.name.literal, argument.default.literal if argument.default else None
        if name and default is not None and name not in assigned:
            defaults[name] = default
    seen = set()
    for found in file.substitutions:
        for bad in bad_expressions(found, defaults) if found.name == "eval" else ():
            if bad.span not in seen:
                seen.add(bad.span)
                yield bad
