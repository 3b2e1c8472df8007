"""Calls of Python functions with a number of arguments that these do not take: they raise TypeError."""

from __future__ import annotations

import ast

from ...languages.python.nodes import last_name
from ...ros.python_calls import OF_INDEX, CallSignature
from ..enumeration import in_ticks

CATCHES = frozenset({"TypeError", "Exception", "BaseException"})
NUMBERS = ("no argument", "one argument", "two arguments", "three arguments", "four arguments", "five arguments")


def wrong_call(call: ast.Call, signature: CallSignature) -> str:
    """Return what is wrong with the arguments of a call; "" where nothing is, or that is known at run time alone."""
    given = [each for each in call.args if not isinstance(each, ast.Starred)]
    if len(given) > signature.most:
        return f"takes {NUMBERS[signature.most]} by position, and is given {len(given)}"
    if len(given) < len(call.args) or any(each.arg is None for each in call.keywords):
        return ""
    named = {each.arg for each in call.keywords}
    missing = [each for each in signature.required[len(given) :] if each not in named]
    return f"needs {in_ticks(missing)} as well" if missing else ""


def wrong_lookup(call: ast.Call) -> str:
    """Return what is wrong with the arguments of a look-up: it raises TypeError before it looks for anything."""
    signature = OF_INDEX.get(last_name(call.func))
    return wrong_call(call, signature) if signature is not None else ""
