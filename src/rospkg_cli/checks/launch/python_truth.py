"""Where Python itself works on substitutions and conditions, and what it makes of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...languages.python.evaluate.values import Call, Constant, PartialText, Text, Value
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.evaluated_launch import EvaluatedLaunch, SubstitutionUse
from ...package.launch.launch_classes import class_of, is_condition, is_resolved_at_run_time, type_name
from ...source import Span
from ..fault import Fault

AT_RUN_TIME = "its text is known only when the launch runs"

NAMED = regex(r"str\([\w.]{1,60}\)")
JOINING = {"&": "AndSubstitution", "|": "OrSubstitution"}
"""Operators that neither substitutions nor conditions have, and what launch has for them."""


@dataclass(frozen=True, slots=True)
class Truth:
    """What Python makes of an expression of substitutions and conditions."""

    makes: Literal["bool", "substitution", "condition"]
    why: str = ""
    """Empty where `use_faults` reports it."""


def truth_values(launch: EvaluatedLaunch) -> dict[Span, Truth]:
    """Return where Python makes a truth value of substitutions, and what it makes."""
    found: dict[Span, Truth] = {}
    for use in launch.uses:
        if is_comparison(use):
            found[use.span] = Truth("bool")
        elif use.name == "not":
            shown = next(type_name(each) for each in use.operands if is_resolved_at_run_time(each))
            found[use.span] = Truth("bool", f"`not` makes False of {shown}, whatever its value at run time")
        elif use.name in ("and", "or") and len(use.operands) > 1 and all(map(is_resolved_at_run_time, use.operands)):
            taken, index = ("first", 0) if use.name == "or" else ("last", -1)
            of = ", ".join(dict.fromkeys(map(type_name, use.operands)))
            why = f"Python's `{use.name}` takes the {taken} of these ({of}), whatever their values"
            found[use.span] = Truth("condition" if is_condition(use.operands[index]) else "substitution", why)
    return found


def use_faults(use: SubstitutionUse, written: str, *, is_tested: bool, is_shown: bool = False) -> Iterator[Fault]:
    """Yield what happens where Python works on a substitution as on a string; launch refuses a bool as a condition.

    `written` is the whole expression; what `is_shown` is only printed.
    """
    if use.kind == "refused":
        shown = type_name(use.operands[0])
        yield Fault(
            use.span, f"`{use.name}` raises TypeError for {shown}" + (" and a string" if use.name == "+" else "")
        )
        return
    shown = next(shown_value(each) for each in use.operands if is_resolved_at_run_time(each))
    if use.kind == "function":
        better = "use PathJoinSubstitution" if use.name == "os.path.join" else "do it in an OpaqueFunction"
        yield Fault(use.span, f"`{use.name}` raises TypeError for {shown}: {AT_RUN_TIME}; {better}")
    elif use.kind == "method":
        yield Fault(use.span, f"{shown} has no `{use.name}`: {AT_RUN_TIME}; do it in an OpaqueFunction")
    elif use.kind == "lookup":
        message = f"no dict has {shown} itself as a key, so this gives the default: {AT_RUN_TIME}"
        yield Fault(use.span, f"{message}; look it up in an OpaqueFunction", "warning")
    elif use.name == "+" and any(map(is_plain, use.operands)):
        yield Fault(use.span, f"`+` raises TypeError for {shown} and a string: put both into a list, `[a, b]`")
    elif use.name in JOINING and all(map(is_resolved_at_run_time, use.operands)):
        better = f"write `IfCondition({JOINING[use.name]}(a, b))`"
        yield Fault(use.span, f"`{use.name}` raises TypeError for {shown}: neither has such an operator; {better}")
    elif use.name in ('f""', "str()"):
        text = "the f-string" if use.name == 'f""' else f"`{written if NAMED.fullmatch(written) else use.name}`"
        message = f"{text} holds the name of an object, `<launch… object at 0x…>`, not the value of {shown}"
        if is_shown:
            yield Fault(use.span, f"{message}: the output shows that; print it in an OpaqueFunction", "info")
        else:
            yield Fault(use.span, f"{message}; make it a list of its parts", "warning")
    elif is_comparison(use):
        outcome = "never" if use.name == "==" else "always"
        better = "use EqualsSubstitution or PythonExpression, or compare in an OpaqueFunction"
        message = f"this is {outcome} true, since {AT_RUN_TIME}: it compares {shown} itself; {better}"
        yield Fault(use.span, message, None if is_tested else "warning")


def shown_value(value: Value) -> str:
    """Return what a value is, a launch configuration with its name."""
    name = value.get("variable_name", 0) if isinstance(value, Call) else None
    if isinstance(value, Call) and class_of(value) == "LaunchConfiguration" and isinstance(name, Text):
        return f"`LaunchConfiguration('{name.text}')`"
    return type_name(value)


def is_plain(value: Value) -> bool:
    return isinstance(value, Text | PartialText)


def is_comparison(use: SubstitutionUse) -> bool:
    """Return whether a substitution is compared with what it never equals: a string or a bool."""
    return use.name in ("==", "!=") and any(
        is_plain(each) or (isinstance(each, Constant) and isinstance(each.value, bool)) for each in use.operands
    )
