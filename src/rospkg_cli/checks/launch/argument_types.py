"""Checks of the arguments of launch classes by their kind: a condition, an output, a period and others (LCH014).

Each check gets an argument and how a sentence names it: "`msg` of `LogInfo`".
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Constant, PartialText, Sequence, Text
from ...languages.python.evaluate.values import Mapping as Dict
from ...package.launch.launch_classes import (
    is_substitution,
    type_name,
    value_span,
)
from ...ros.launch_calls import OUTPUTS, Kind
from ..fault import Fault
from .list_arguments import actions_faults, pairs_faults, remappings_faults
from .parameter_types import parameters_faults
from .python_truth import shown_value
from .text_arguments import constant_fault, paths_faults, text_faults, words_faults


def condition_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if is_substitution(value) or isinstance(value, Text | PartialText | Constant | Sequence | Dict):
        shown = shown_value(value) if is_substitution(value) else type_name(value)
        message = f"{what} takes IfCondition or UnlessCondition, not {shown}: the launch stops with "
        yield Fault(value_span(argument), f"{message}\"object has no attribute 'evaluate'\"")


def output_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if isinstance(value, Text) and value.text not in OUTPUTS:
        known = ", ".join(f"`{name}`" for name in sorted(OUTPUTS))
        yield Fault(value_span(argument), f"{what} can't be `{value.text}`, only {known}: the node is not started")
    elif isinstance(value, Constant):
        yield Fault(value_span(argument), f"{what} takes a string, not {type_name(value)}: launch raises TypeError")


def period_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if isinstance(value, Constant) and type(value.value) is int:
        message = f"{what} takes a float, and launch raises TypeError for {type_name(value)}"
        yield constant_fault(value, value_span(argument), message, f"{value.value}.0")


TYPE_CHECKS: Mapping[Kind, Callable[[Argument, str], Iterator[Fault]]] = {
    "text": text_faults,
    "words": words_faults,
    "paths": paths_faults,
    "condition": condition_faults,
    "actions": actions_faults,
    "pairs": pairs_faults,
    "output": output_faults,
    "period": period_faults,
    "parameters": parameters_faults,
    "remappings": remappings_faults,
}
