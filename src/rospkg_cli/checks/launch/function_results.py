"""What generate_launch_description and functions of OpaqueFunction return, where launch cannot use it (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, Constant, Function, Sequence
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of, type_name
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ..fault import Fault
from .list_arguments import action_list_faults

DESCRIBES = "generate_launch_description"


def description_faults(launch: EvaluatedLaunch) -> Iterator[Fault]:
    """Yield what `generate_launch_description` returns instead of a LaunchDescription."""
    for function, value in (launch.returned or {}).values():
        if function.name != DESCRIBES or function.scope is not launch.scope or function.is_decorated:
            continue
        if isinstance(value, Constant | Sequence) or (isinstance(value, Call) and class_of(value) in ACTIONS):
            start = launch.file.source.text.index(DESCRIBES, function.span.start)
            message = f"`{DESCRIBES}` returns {type_name(value)} and no LaunchDescription: the launch stops"
            yield Fault(Span(start, start + len(DESCRIBES)), message)


def function_faults(call: Call, launch: EvaluatedLaunch) -> Iterator[Fault]:
    """Yield what is wrong with the function of an OpaqueFunction: it takes the context and returns a list."""
    function = call.get("function", 0)
    if isinstance(function, Sequence | Constant):
        message = f"`function` of `OpaqueFunction` takes a function, not its result ({type_name(function)})"
        yield Fault(function.span, f"{message}: launch raises TypeError")
    if not isinstance(function, Function):
        return
    parameters = function.node.args
    if not (parameters.posonlyargs or parameters.args or parameters.vararg):
        yield Fault(call.span, f"launch calls `{function.name}` with the context, and it takes no argument: TypeError")
    value = launch.result_of(function)
    what = f"what `{function.name}` returns"
    if isinstance(value, Call) and (class_of(value) in ACTIONS or class_of(value) == "LaunchDescription"):
        yield Fault(value.span, f"{what} has to be a list of actions, not {type_name(value)}: the launch stops")
    elif isinstance(value, Sequence):
        yield from action_list_faults(value, what)
