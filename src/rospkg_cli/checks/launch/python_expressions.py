"""LCH007: Python expressions in launch files (`PythonExpression`, `$(eval …)`), as Python would read their text."""

from __future__ import annotations

import ast
import builtins
import math
import warnings
from collections.abc import Iterator, Mapping

from ...languages.python.nodes import nodes_of
from ...package.launch.argument_defaults import literal_defaults
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText, Literal, Substitution
from ...source import Span
from ..fault import Fault

PLACEHOLDERS = ("a", "0", "a.b", "")
"""Values for what only the launch knows: an expression that parses with none of them is wrong."""

KNOWN = frozenset(dir(builtins)) | frozenset(vars(math)) | {"math"}
MAX_TEXT = 4000


def expression_faults(file: LaunchFile) -> Iterator[Fault]:
    """Yield the bad expressions of a file, each place once, with the defaults of its own arguments filled in."""
    if not file.has_entry_point or file.is_ros1:
        return
    defaults = literal_defaults(file.arguments, file.assigned)
    found: dict[Span, Fault] = {}
    for each in file.substitutions:
        for fault in faults_of(each, defaults) if each.name == "eval" else ():
            found.setdefault(fault.span, fault)
    yield from found.values()


def faults_of(found: Substitution, defaults: Mapping[str, str]) -> Iterator[Fault]:
    """Yield what is wrong with one expression; a warning where the default of an argument brings it in."""
    if not found.arguments or len(found.arguments) > 1:
        return
    expression = found.arguments[0]
    if any(isinstance(part, Substitution) and part.name in ("?", "eval") for part in expression.parts):
        return
    shown = filled(expression, "…", {})
    if len(shown) > MAX_TEXT:
        return
    if all(parsed(filled(expression, each, {})) is None for each in PLACEHOLDERS):
        yield Fault(found.span, f"`{shown.strip()}` is no Python expression: launch stops with SyntaxError")
        return
    usual = filled(expression, None, defaults)
    tree = parsed(usual)
    for name in unknown_names(tree) if tree is not None else ():
        hint = f"; write {name.title()}" if name in ("true", "false") else ""
        message = f"`{usual.strip()}` uses the unknown name `{name}`: launch stops with NameError{hint}"
        is_literal = any(name in part.text for part in expression.parts if isinstance(part, Literal))
        yield Fault(found.span, message, None if is_literal else "warning")


def filled(text: LaunchText, placeholder: str | None, defaults: Mapping[str, str]) -> str:
    """Return the text with every substitution replaced; by the default of an argument where there is one."""
    parts = []
    for part in text.parts:
        if isinstance(part, Literal):
            parts.append(part.text)
            continue
        name = part.arguments[0].literal if part.name == "var" and part.arguments else None
        parts.append(defaults.get(name or "", placeholder if placeholder is not None else "0"))
    return "".join(parts)


def parsed(text: str) -> ast.Expression | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def unknown_names(tree: ast.Expression) -> Iterator[str]:
    """Yield the names that are no builtin, none of `math` and not bound in the expression, each once."""
    bound = {node.id for node in nodes_of(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    bound |= {node.arg for node in nodes_of(tree) if isinstance(node, ast.arg)}
    used = (node.id for node in nodes_of(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load))
    yield from (name for name in dict.fromkeys(used) if name not in bound | KNOWN)
