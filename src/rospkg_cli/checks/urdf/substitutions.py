"""Substitutions of xacro: `${expression}`, `$(command)`. (xacro/__init__.py and substitution_args.py, branch ros2)"""

from __future__ import annotations

import ast
import warnings

from ...lazy_regex import regex

TOKEN = regex(r"\$\$+[{(]|\$\{[^}]*\}|\$\([^)]*\)|[^$]+|\$[^{($]+|\$$")
COMMANDS = {"find": (1, 1), "env": (1, 1), "optenv": (1, 99), "dirname": (0, 0), "arg": (1, 1), "cwd": (0, 0)}
"""Each command with how many words may follow it; `eval` takes everything."""
SUGGESTIONS = {"find-pkg-share": "find", "find-pkg-prefix": "find", "var": "arg", "arg_": "arg", "finds": "find"}


def substitution_fault(text: str) -> tuple[int, int, str] | None:
    """Return start, end, and what is wrong with the first substitution that xacro refuses."""
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            closing = "}" if text.startswith("${", at) else ")"
            return at, len(text), f"`{text[at : at + 30]}` is never closed: a `{closing}` is missing"
        token = match.group()
        if token.startswith(("${", "$(")):
            fault = expression_fault(token[2:-1]) if token[1] == "{" else command_fault(token)
            if fault:
                return at, match.end(), fault
        at = match.end()
    return None


def expression_fault(expression: str) -> str | None:
    if "$" in expression or "{" in expression or len(expression) > 2000:
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(expression.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return f"`${{{expression}}}` holds no expression that xacro can evaluate"
    return None


def command_fault(token: str) -> str | None:
    words = token[2:-1].split()
    if "$" in token[1:] or "(" in token[2:] or words[:1] == ["eval"]:
        return None
    if not words:
        return "`$()` is empty"
    if words[0] not in COMMANDS:
        suggestion = SUGGESTIONS.get(words[0])
        hint = (
            f": write `$({suggestion} {' '.join(words[1:])})`"
            if suggestion
            else f"; it knows {', '.join(COMMANDS)} and eval"
        )
        return f"xacro knows no `$({words[0]} …)`{hint}"
    least, most = COMMANDS[words[0]]
    if not least <= len(words) - 1 <= most:
        return f"`{token}`: `{words[0]}` takes {'one word' if most else 'nothing'} behind it"
    return None
