"""What rosidl refuses in an interface file, or reads otherwise than it is written, with the repairs."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.interfaces.grammar_problem import GrammarProblem
from ...package.interfaces.interface_file import InterfaceFile
from ..fault import Fault, TextRepair
from .grammar_sentences import sentence_of, title_of


def grammar_faults(interface: InterfaceFile) -> Iterator[Fault]:
    for problem in interface.problems:
        yield Fault(problem.span, sentence_of(problem), repair=repair_of(problem))


def repair_of(problem: GrammarProblem) -> TextRepair | None:
    if problem.repair is None or problem.repair_span is None:
        return None
    return TextRepair(title_of(problem), ((problem.repair_span, problem.repair),), problem.is_certain)
