"""LCH014: calls of a Python launch file that launch or Python refuses, and results that launch can't use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated

from ...languages.python.evaluate.values import Argument, Call, Constant, Function, Sequence, Value
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.launch.evaluated_launch import EvaluatedLaunch, SubstitutionUse
from ...package.launch.launch_classes import class_of, named_arguments, type_name
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_launched
from ...ros.launch_calls import ACTIONS, SIGNATURES, Signature
from ...source import Span
from ...suggest import nearest
from ...unreadable import READABLE
from ..fault import Fault, softer, softer_advice
from ..paths.logged_texts import logged_spans
from ..repository.older_distribution import OlderDistribution
from .argument_types import TYPE_CHECKS, action_list_faults
from .idle_actions import NEVER_CALLED, UNUSED, is_uncalled
from .include_sources import source_faults
from .joined_commands import joined_command, joined_mapping, joined_words
from .joined_options import joined_options
from .lone_commas import added_faults, at_the_comma, lone_commas, used_at_the_comma
from .lost_faults import where_met
from .missing_references import LaunchContext
from .performed_texts import performed_faults
from .program_prefixes import PROCESSES
from .python_truth import Truth, is_comparison, test_faults, truth_values, use_faults
from .relative_parameter_files import values_as_files
from .removed_arguments import renamed
from .uncalled_values import uncalled_faults

LATER = "`LifecycleNode` is called without its required `namespace`"
"""What Foxy lets pass."""
VARIABLE = regex(r"[A-Za-z_][\w.]{0,60}")
DESCRIBES = "generate_launch_description"
ANY_ARGUMENT = frozenset(name for signature in SIGNATURES.values() for name in signature.kinds)
"""Arguments that some class of launch has."""
VISITED = frozenset({"condition", "output", "actions", "pairs"})
"""Kinds of arguments that launch looks at when it visits the action, and not when Python makes it."""


@dataclass(frozen=True)
class LaunchCalls:
    file: LaunchFile
    distribution: OlderDistribution
    scopes: Annotated[tuple[LaunchContext, ...], READABLE] = ()
    """All launch files of the package, where what they are among can be read."""

    def faults(self) -> Iterator[Fault]:
        """Yield what launch or Python refuses; an info where the only distribution that is meant lets it pass."""
        own = next((each for each in self.scopes if each.file.path == self.file.path), None)
        found = call_faults(self.file)
        for fault in found if own is None else where_met(own, found):
            is_later = fault.level is None and fault.message.startswith(LATER)
            if is_later and self.distribution.is_for_older(self.file.path):
                yield softer(fault, "info", "but not in Foxy")
            else:
                yield fault


def call_faults(file: LaunchFile) -> list[Fault]:
    """Return the faults in the order of the text, one for each place; none where launch can't start the file."""
    if file.evaluated is None or not file.has_entry_point:
        return []
    truths = truth_values(file.evaluated)
    found: dict[Span, Fault] = {}
    for each in (*every_fault(file.evaluated, truths), *values_as_files(file)):
        is_lost = is_uncalled(file.evaluated.file, each.span) and each.level != "info"
        found.setdefault(each.span, softer_advice(each, "info", NEVER_CALLED) if is_lost else each)
    whole = [span for span in found if span in truths]
    inside = {a for a in found for b in whole if a != b and b.contains(a)}
    return [found[span] for span in sorted(found) if span not in inside]


def every_fault(launch: EvaluatedLaunch, truths: Mapping[Span, Truth]) -> Iterator[Fault]:
    idle, commas = tuple(never_launched(launch.file)), lone_commas(launch.file)
    for call in launch.calls:
        yield from (at_the_comma(fault, argument, commas) for fault, argument in added_faults(call))
        signature = SIGNATURES.get(class_of(call))
        if signature is not None:
            yield from signature_faults(call, class_of(call), signature)
            is_idle = any(each.contains(call.span) for each in idle)
            for keyword, argument in named_arguments(call, signature):
                late = is_idle and signature.kinds.get(keyword) in VISITED
                for found in argument_faults(class_of(call), keyword, argument, truths):
                    fault = at_the_comma(with_its_name(found, argument, launch), argument, commas)
                    yield softer(fault, "info", "as soon as the action is added") if late else fault
    tested = {argument.value.span for call in launch.calls for argument in tests_of(call)}
    shown = logged_spans(launch.file)
    for use in launch.uses:
        if is_comparison(use) and is_for_others(use, launch):
            continue
        is_idle, is_shown = (any(each.contains(use.span) for each in spans) for spans in (idle, shown))
        written = launch.file.source.slice(use.span)
        for fault in use_faults(use, written, is_tested=use.span in tested, is_shown=is_shown):
            fault = used_at_the_comma(fault, use.operands, commas)
            yield softer(fault, "info", UNUSED) if is_idle and fault.level else fault
    yield from test_faults(launch)
    yield from performed_faults(launch)
    yield from description_faults(launch)
    for fault in source_faults(launch):
        is_idle = any(each.contains(fault.span) for each in idle)
        yield softer(fault, "info", UNUSED) if is_idle else fault
    for call in launch.calls:
        yield from joined_options(call, launch.file.source)
        if class_of(call) == "OpaqueFunction":
            yield from function_faults(call, launch)
        elif class_of(call) == "Command":
            yield from joined_command(call)
            yield from joined_mapping(call)
        elif class_of(call) in PROCESSES:
            yield from joined_words(call)


def is_for_others(use: SubstitutionUse, launch: EvaluatedLaunch) -> bool:
    from .told_apart import is_told_apart  # few launch files compare a substitution

    return is_told_apart(use, launch.file)


def signature_faults(call: Call, name: str, signature: Signature) -> Iterator[Fault]:
    """Yield why Python refuses a call: unexpected keyword, missing argument, too many positional arguments."""
    known, old = signature.kinds.keys(), renamed(name)
    intended = set()
    for argument in call.arguments:
        if argument.name and argument.name not in known and argument.name not in old:
            near = nearest(argument.name, known - {"condition"} if argument.name != "conditions" else known)
            if near or argument.name in ANY_ARGUMENT:
                intended.add(near)
                hint = f"; did you mean `{near}`?" if near else ""
                yield Fault(argument.span, f"`{name}` takes no `{argument.name}`: Python raises TypeError{hint}")
        intended.add(old.get(argument.name))
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
