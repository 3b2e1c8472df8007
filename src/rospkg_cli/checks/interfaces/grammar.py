"""What rosidl refuses in an interface file, or reads otherwise than it is written, with the repairs."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.interfaces.grammar_problem import GrammarCode, GrammarProblem
from ...package.interfaces.interface_file import InterfaceFile
from ..fault import Fault, TextRepair, joined
from .grammar_sentences import sentence_of, title_of

VALUES = frozenset({GrammarCode.NO_BOOL, GrammarCode.NO_INTEGER, GrammarCode.NO_FLOAT})
"""Values that are none of their type."""


def grammar_faults(interface: InterfaceFile) -> Iterator[Fault]:
    """Yield what rosidl refuses; lines that all end as in C are one fault."""
    text = interface.source.text
    ends = [each for each in interface.problems if text[each.span.start : each.span.end].endswith(";")]
    if len(ends) > 1:
        faults = [Fault(each.span, "", repair=repair_of(each)) for each in ends]
        yield joined(
            faults,
            "the lines end with `;`, which rosidl refuses: one field a line, without a sign at its end",
            "remove each `;`",
        )
    for problem in interface.problems:
        if len(ends) < 2 or problem not in ends:
            yield Fault(problem.span, sentence(interface, problem), repair=repair_of(problem))


def sentence(interface: InterfaceFile, problem: GrammarProblem) -> str:
    """Return what is wrong, with the name of the constant or field whose value is."""
    said, start = sentence_of(problem), problem.span.start
    spans = ((member.name, member.value_span) for member in interface.members if problem.code in VALUES)
    name = next((name for name, span in spans if span is not None and span.start <= start < span.end), None)
    return said if name is None else f"{said}; it is the value of `{name}`"


def repair_of(problem: GrammarProblem) -> TextRepair | None:
    if problem.repair is None or problem.repair_span is None:
        return None
    return TextRepair(title_of(problem), ((problem.repair_span, problem.repair),), problem.is_certain)
