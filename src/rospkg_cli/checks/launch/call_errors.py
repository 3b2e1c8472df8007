"""LCH014: calls of a Python launch file that launch or Python refuses, and results that launch can't use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Constant, Function, PartialText, Sequence, Text, Value
from ...package.launch.evaluated_launch import EvaluatedLaunch, SubstitutionUse
from ...package.launch.launch_classes import class_of, is_resolved_at_run_time, named_arguments, type_name
from ...package.launch.launch_file import LaunchFile
from ...ros.launch_calls import ACTIONS, SIGNATURES, Signature
from ...source import Span
from ...suggest import nearest
from ..fault import Fault
from .argument_types import TYPE_CHECKS, action_list_faults
from .removed_arguments import RENAMED

DESCRIBES = "generate_launch_description"
ANY_ARGUMENT = frozenset(name for signature in SIGNATURES.values() for name in signature.kinds)
"""Arguments that some class of launch has."""
AT_RUN_TIME = "its text is known only when the launch runs"


def call_faults(file: LaunchFile) -> list[Fault]:
    """Return the faults in the order of the text, one for each place; none where launch can't start the file."""
    if file.evaluated is None or not file.has_entry_point:
        return []
    truths = truth_values(file.evaluated)
    found: dict[Span, Fault] = {}
    for each in every_fault(file.evaluated, truths):
        found.setdefault(each.span, each)
    whole = [span for span in found if span in truths]
    inside = {a for a in found for b in whole if a != b and b.start <= a.start and a.end <= b.end}
    return [found[span] for span in sorted(found) if span not in inside]


def every_fault(launch: EvaluatedLaunch, truths: Mapping[Span, str]) -> Iterator[Fault]:
    for call in launch.calls:
        signature = SIGNATURES.get(class_of(call))
        if signature is not None:
            yield from signature_faults(call, class_of(call), signature)
            for keyword, argument in named_arguments(call, signature):
                yield from argument_faults(class_of(call), keyword, argument, truths)
    for use in launch.uses:
        yield from use_faults(use)
    yield from description_faults(launch)
    for call in launch.calls:
        if class_of(call) == "OpaqueFunction":
            yield from function_faults(call, launch)


def signature_faults(call: Call, name: str, signature: Signature) -> Iterator[Fault]:
    """Yield why Python refuses a call: unexpected keyword, missing argument, too many positional arguments."""
    known = signature.kinds.keys()
    intended = set()
    for argument in call.arguments:
        if argument.name and argument.name not in known and argument.name not in RENAMED:
            near = nearest(argument.name, known - {"condition"} if argument.name != "conditions" else known)
            if near or argument.name in ANY_ARGUMENT:
                intended.add(near)
                hint = f"; did you mean `{near}`?" if near else ""
                yield Fault(argument.span, f"`{name}` takes no `{argument.name}`: Python raises TypeError{hint}")
        intended.add(RENAMED.get(argument.name))
    positional = [argument for argument in call.arguments if not argument.name]
    most = len(signature.positional)
    if len(positional) > most:
        limit = f"at most {most} positional argument{'s' * (most != 1)}" if most else "keyword arguments only"
        yield Fault(positional[most].span, f"`{name}` takes {limit}: Python raises TypeError")
        return
    present = {found for found, _ in named_arguments(call, signature)} | intended
    for missing in sorted(signature.required - present):
        if call.rest is None:
            yield Fault(call.span, f"`{name}` is called without its required `{missing}`: Python raises TypeError")


def argument_faults(name: str, keyword: str, argument: Argument, truths: Mapping[Span, str]) -> Iterator[Fault]:
    """Yield what is wrong with one argument: a condition that Python evaluated itself, or its type."""
    signature, value = SIGNATURES[name], argument.value
    kind = signature.kinds.get(keyword, "any")
    if (kind == "condition" or keyword == "predicate_expression") and value.span in truths:
        if why := truths[value.span]:
            better = "combine them in a PythonExpression, or with AndSubstitution, OrSubstitution"
            yield Fault(value.span, f"{why}: {better}")
    elif kind in TYPE_CHECKS and not (keyword in signature.optional and is_none(value)):
        yield from TYPE_CHECKS[kind](argument, f"`{keyword}` of `{name}`")


def is_none(value: Value) -> bool:
    return isinstance(value, Constant) and value.value is None


def is_plain(value: Value) -> bool:
    return isinstance(value, Text | PartialText)


def is_comparison(use: SubstitutionUse) -> bool:
    """Return whether a substitution is compared with what it never equals: a string or a bool."""
    return use.name in ("==", "!=") and any(
        is_plain(each) or (isinstance(each, Constant) and isinstance(each.value, bool)) for each in use.operands
    )


def truth_values(launch: EvaluatedLaunch) -> dict[Span, str]:
    """Return where Python makes a truth value of substitutions, and what it makes; "" where `use_faults` reports it."""
    found: dict[Span, str] = {}
    for use in launch.uses:
        if is_comparison(use):
            found[use.span] = ""
        elif use.name == "not":
            shown = next(type_name(each) for each in use.operands if is_resolved_at_run_time(each))
            found[use.span] = f"`not` makes False of {shown}, whatever its value at run time"
        elif use.name in ("and", "or") and len(use.operands) > 1 and all(map(is_resolved_at_run_time, use.operands)):
            taken = "first" if use.name == "or" else "last"
            of = ", ".join(dict.fromkeys(map(type_name, use.operands)))
            found[use.span] = f"Python's `{use.name}` takes the {taken} of these ({of}), whatever their values"
    return found


def use_faults(use: SubstitutionUse) -> Iterator[Fault]:
    """Yield what happens where Python works on a substitution as on a string."""
    shown = next(type_name(each) for each in use.operands if is_resolved_at_run_time(each))
    if use.kind == "function":
        better = "use PathJoinSubstitution" if use.name == "os.path.join" else "do it in an OpaqueFunction"
        yield Fault(use.span, f"`{use.name}` raises TypeError for {shown}: {AT_RUN_TIME}; {better}")
    elif use.kind == "method":
        yield Fault(use.span, f"{shown} has no `{use.name}`: {AT_RUN_TIME}; do it in an OpaqueFunction")
    elif use.name == "+" and any(map(is_plain, use.operands)):
        yield Fault(use.span, f"`+` raises TypeError for {shown} and a string: put both into a list, `[a, b]`")
    elif use.name == 'f""':
        message = "the f-string holds the name of an object, `<launch… object at 0x…>`"
        yield Fault(use.span, f"{message}, not the value of {shown}; make it a list of its parts")
    elif is_comparison(use):
        outcome = "never" if use.name == "==" else "always"
        better = "use EqualsSubstitution or PythonExpression, or compare in an OpaqueFunction"
        yield Fault(use.span, f"this is {outcome} true, since {AT_RUN_TIME}: it compares {shown} itself; {better}")


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
