"""LCH014: calls of a Python launch file that launch or Python refuses, and results that launch can't use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.launch.evaluated_launch import EvaluatedLaunch, SubstitutionUse
from ...package.launch.launch_classes import class_of, named_arguments
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_launched
from ...ros.launch_calls import SIGNATURES
from ...source import Span
from ...unreadable import READABLE
from ..fault import Fault, softer, softer_advice
from ..paths.logged_texts import logged_spans
from ..repository.older_distribution import OlderDistribution
from .always_true_tests import test_faults
from .call_arguments import argument_faults, tests_of, with_its_name
from .call_signatures import signature_faults
from .function_results import description_faults, function_faults
from .idle_actions import NEVER_CALLED, UNUSED, is_uncalled
from .include_sources import source_faults
from .joined_commands import joined_command, joined_mapping, joined_words
from .joined_options import joined_options
from .launch_context import LaunchContext
from .lone_commas import added_faults, at_the_comma, lone_commas, used_at_the_comma
from .lost_faults import where_met
from .performed_texts import performed_faults
from .program_prefixes import PROCESSES
from .python_truth import Truth, is_comparison, truth_values, use_faults
from .relative_parameter_files import values_as_files

LATER = "`LifecycleNode` is called without its required `namespace`"
"""How the message begins about a call that Foxy accepts."""
VISITED = frozenset({"condition", "output", "actions", "pairs"})
"""Kinds of arguments that launch looks at when it visits the action, and not when Python makes it."""


@dataclass(frozen=True)
class LaunchCalls:
    file: LaunchFile
    distribution: OlderDistribution
    scopes: Annotated[tuple[LaunchContext, ...], READABLE] = ()
    """All launch files of the package, where what they are among can be read."""

    def faults(self) -> Iterator[Fault]:
        """Yield what launch or Python refuses; an info where the repository is for Foxy alone and Foxy accepts it."""
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
    """Return whether a comparison is for plain values, and the code around it performs substitutions."""
    from .guarded_comparisons import is_guarded  # few launch files compare a substitution

    return is_guarded(use, launch.file)
