"""The functions of Python's builtins and standard library that are evaluated, by full name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .formatting import as_text, format_value
from .iterables import plain_function
from .iterator_builtins import ITERATOR_BUILTINS
from .path_functions import PATH_FUNCTIONS
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Class, Constant, Function, Sequence, Symbol, Text, Value
from .values import Mapping as MappingValue

MAX_DIGITS = 1_000

TYPES: Mapping[str, type | tuple[type, ...]] = {
    "str": str, "int": int, "float": float, "bool": bool, "list": list, "tuple": tuple, "dict": dict, "set": set,
}  # fmt: skip


def as_str(state: EvaluationState, call: Call) -> Value | None:
    return as_text(call.positional[0], call.span) if len(call.positional) == 1 else None


def as_bool(state: EvaluationState, call: Call) -> Value | None:
    verdict = truth(call.positional[0]) if call.positional else False
    return None if verdict is None else Constant(call.span, verdict)


def as_repr(state: EvaluationState, call: Call) -> Value | None:
    return format_value(call.positional[0], "", "r", call.span) if len(call.positional) == 1 else None


def is_instance(state: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    value, asked = call.positional
    wanted = asked.items if isinstance(asked, Sequence) else [asked]
    names = {symbol.name for symbol in wanted if isinstance(symbol, Symbol)}
    match value:
        case Text():
            own = {"pathlib.Path", "pathlib.PurePath"} if value.is_path else {"str"}
        case Sequence():
            own = {value.kind}
        case MappingValue():
            own = {"dict"}
        case Constant():
            own = {kind.__name__ for kind in type(value.value).__mro__}
        case _:
            return None
    return Constant(call.span, bool(own & names)) if len(names) == len(wanted) else None


def bounded_int(value: Any = 0, base: Any = None) -> int:
    """int(); raises ValueError for very long texts: the time is quadratic in their length."""
    if isinstance(value, str | bytes) and len(value) > MAX_DIGITS:
        raise ValueError
    return int(value) if base is None else int(value, base)


def bounded_round(number: Any, digits: Any = None) -> Any:
    """round(); raises ValueError for so many digits that the power of ten would not end."""
    if digits is not None and abs(digits) > MAX_DIGITS:
        raise ValueError
    return round(number, digits)


def returns_none(state: EvaluationState, call: Call) -> Value | None:
    return Constant(call.span, None)


def is_callable(state: EvaluationState, call: Call) -> Value | None:
    value = call.positional[0] if call.positional else None
    if isinstance(value, Function | Class):
        return Constant(call.span, True)
    return Constant(call.span, False) if isinstance(value, Constant | Text | Sequence | MappingValue) else None


ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
"""The variables that are the same wherever a ROS 2 package is built (REP-149 knows them too)."""


def environment_variable(state: EvaluationState, call: Call) -> Value | None:
    """os.environ and os.getenv."""
    name = call.positional[0] if call.positional else None
    text = ENVIRONMENT.get(name.text) if isinstance(name, Text) else None
    if text is None:
        return state.unknown(call.span, f"{state.quoted(call.span)} depends on the environment")
    return Text(call.span, text)


LIBRARY: Mapping[str, Intrinsic] = {
    **ITERATOR_BUILTINS,
    **PATH_FUNCTIONS,
    "str": as_str,
    "bool": as_bool,
    "repr": as_repr,
    "int": plain_function(bounded_int),
    "float": plain_function(float),
    "abs": plain_function(abs),
    "round": plain_function(bounded_round),
    "ord": plain_function(ord),
    "chr": plain_function(chr),
    "isinstance": is_instance,
    "callable": is_callable,
    "os.environ[]": environment_variable,
    "os.environ.get": environment_variable,
    "os.getenv": environment_variable,
    "print": returns_none,
    "warnings.warn": returns_none,
    "warnings.filterwarnings": returns_none,
    "copy.copy": lambda state, call: call.positional[0] if call.positional else None,
}
