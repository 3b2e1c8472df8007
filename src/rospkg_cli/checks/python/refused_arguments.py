"""Why parameters of a method do not take the arguments of a call."""

from __future__ import annotations

import ast

from ..enumeration import in_ticks
from .wrong_calls import NUMBERS


def why_refused(taken: ast.arguments, call: ast.Call) -> str:
    """Return why parameters, of which the first one is the object, don't take a call's arguments; "" if they may."""
    places = [each.arg for each in (*taken.posonlyargs, *taken.args)][1:]
    names = {
        *(each.arg for each in taken.args[0 if taken.posonlyargs else 1 :]),
        *(each.arg for each in taken.kwonlyargs),
    }
    named = [each.arg for each in call.keywords if each.arg is not None]
    given = [each for each in call.args if not isinstance(each, ast.Starred)]
    strange = [each for each in named if each not in names]
    if strange and taken.kwarg is None:
        return f"has no {in_ticks(strange[:1])}"
    if len(given) > len(places) and taken.vararg is None:
        return f"takes {number(len(places))} by position, and is given {len(given)}"
    if len(given) < len(call.args) or len(named) < len(call.keywords):
        return ""
    needed = places[: max(0, len(places) - len(taken.defaults))][len(given) :]
    needed += [each.arg for each, value in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if value is None]
    missing = [each for each in needed if each not in named]
    return f"needs {in_ticks(missing)} as well" if missing else ""


def number(count: int) -> str:
    return NUMBERS[count] if count < len(NUMBERS) else f"{count} arguments"
