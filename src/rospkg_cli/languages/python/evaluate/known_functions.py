"""Everything that the evaluator knows of Python's builtins and standard library, by full name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .formatting import as_text, in_format
from .iterables import pure
from .iterator_builtins import ITERATION
from .path_functions import PATHS
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, Function, Sequence, Symbol, Text, Value
from .values import Mapping as MappingValue

MAX_DIGITS = 1_000

TYPES: Mapping[str, type | tuple[type, ...]] = {
    "str": str, "int": int, "float": float, "bool": bool, "list": list, "tuple": tuple, "dict": dict, "set": set,
}  # fmt: skip


def as_str(machine: EvaluationState, call: Call) -> Value | None:
    return as_text(call.positional[0], call.span) if len(call.positional) == 1 else None


def as_bool(machine: EvaluationState, call: Call) -> Value | None:
    verdict = truth(call.positional[0]) if call.positional else False
    return None if verdict is None else Constant(call.span, verdict)


def represented(machine: EvaluationState, call: Call) -> Value | None:
    return in_format(call.positional[0], "", "r", call.span) if len(call.positional) == 1 else None


def is_instance(machine: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    value, asked = call.positional
    wanted = asked.items if isinstance(asked, Sequence) else [asked]
    names = {symbol.name for symbol in wanted if isinstance(symbol, Symbol)}
    match value:
        case Text():
            own = {"pathlib.Path", "pathlib.PurePath"} if value.path else {"str"}
        case Sequence():
            own = {value.kind}
        case MappingValue():
            own = {"dict"}
        case Constant():
            own = {kind.__name__ for kind in type(value.value).__mro__}
        case _:
            return None
    return Constant(call.span, bool(own & names)) if len(names) == len(wanted) else None


def as_int(value: Any = 0, base: Any = None) -> int:
    """int(); raises ValueError for texts that no interpreter should be given: the time is quadratic in their length."""
    if isinstance(value, str | bytes) and len(value) > MAX_DIGITS:
        raise ValueError
    return int(value) if base is None else int(value, base)


def rounded(number: Any, digits: Any = None) -> Any:
    """round(); raises ValueError for so many digits that the power of ten would not end."""
    if digits is not None and abs(digits) > MAX_DIGITS:
        raise ValueError
    return round(number, digits)


def nothing(machine: EvaluationState, call: Call) -> Value | None:
    return Constant(call.span, None)


def is_callable(machine: EvaluationState, call: Call) -> Value | None:
    return Constant(call.span, isinstance(call.positional[0], Function)) if call.positional else None


ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
"""The variables that are the same wherever a ROS 2 package is built (REP-149 knows them too)."""


def variable(machine: EvaluationState, call: Call) -> Value | None:
    """os.environ, whichever way it is asked."""
    name = call.positional[0] if call.positional else None
    text = ENVIRONMENT.get(name.text) if isinstance(name, Text) else None
    if text is None:
        return machine.unknown(call.span, f"{machine.shown(call.span)} depends on the environment")
    return Text(call.span, text)


LIBRARY: Mapping[str, Intrinsic] = {
    **ITERATION,
    **PATHS,
    "str": as_str,
    "bool": as_bool,
    "repr": represented,
    "int": pure(as_int),
    "float": pure(float),
    "abs": pure(abs),
    "round": pure(rounded),
    "ord": pure(ord),
    "chr": pure(chr),
    "isinstance": is_instance,
    "callable": is_callable,
    "os.environ[]": variable,
    "os.environ.get": variable,
    "os.getenv": variable,
    "print": nothing,
    "warnings.warn": nothing,
    "warnings.filterwarnings": nothing,
    "copy.copy": lambda machine, call: call.positional[0] if call.positional else None,
}
