"""Arguments of launch classes: conditions that Python evaluates itself, and values of a wrong type (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Constant, Value
from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of, named_arguments
from ...ros.launch_calls import SIGNATURES
from ...source import Span
from ..fault import Fault
from .argument_types import TYPE_CHECKS
from .python_truth import Truth
from .uncalled_values import uncalled_faults

VARIABLE = regex(r"[A-Za-z_][\w.]{0,60}")


def argument_faults(name: str, keyword: str, argument: Argument, truths: Mapping[Span, Truth]) -> Iterator[Fault]:
    """Yield what is wrong with one argument: a condition that Python evaluated itself, or its type."""
    signature, value = SIGNATURES[name], argument.value
    kind = signature.kinds.get(keyword, "any")
    if is_test(kind, keyword) and value.span in truths:
        if why := truths[value.span].why:
            better = "combine them in a PythonExpression, or with AndSubstitution, OrSubstitution"
            wanted = "condition" if kind == "condition" else "substitution"
            yield Fault(value.span, f"{why}: {better}", "warning" if truths[value.span].makes == wanted else None)
    elif kind in TYPE_CHECKS and not (keyword in signature.optional and is_none(value)):
        yield from TYPE_CHECKS[kind](argument, f"`{keyword}` of `{name}`")
        yield from uncalled_faults(kind, argument, f"`{keyword}` of `{name}`")


def with_its_name(fault: Fault, argument: Argument, launch: EvaluatedLaunch) -> Fault:
    """Return a fault with the name of the variable that `str()` is missing around."""
    name = launch.file.source.slice(argument.span).rpartition("=")[2].strip()
    said = fault.message.removesuffix("use str()")
    is_one = said != fault.message and fault.span == argument.span and VARIABLE.fullmatch(name)
    return replace(fault, message=f"{said}use `str({name})`") if is_one else fault


def is_test(kind: str, keyword: str) -> bool:
    return kind == "condition" or keyword == "predicate_expression"


def tests_of(call: Call) -> Iterator[Argument]:
    """Yield the arguments of which launch itself wants a truth value."""
    signature = SIGNATURES.get(class_of(call))
    if signature is None:
        return
    for keyword, argument in named_arguments(call, signature):
        if is_test(signature.kinds.get(keyword, "any"), keyword):
            yield argument


def is_none(value: Value) -> bool:
    return isinstance(value, Constant) and value.value is None
