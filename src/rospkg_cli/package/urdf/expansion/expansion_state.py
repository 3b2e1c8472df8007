"""Where the expansion of a robot is, and what it tells."""

from __future__ import annotations

from collections.abc import Iterable

from ....languages.xml.parser import Element
from ....light_dataclasses import dataclass, field, replace
from ....source import Source, Span
from .expansion import Expansion, FoundProblem, XacroProblem
from .library import XacroLibrary
from .texts import TextEvaluator
from .values import Value, XacroPlace, XacroScope

MAX_PROBLEMS = 200


@dataclass(frozen=True)
class Context:
    """Where the expansion is."""

    source: Source
    scope: XacroScope
    is_certain: bool = True
    calls: tuple[tuple[Source, Element], ...] = ()
    depth: int = 0


@dataclass
class ExpansionState:
    """What is known while a robot is expanded: where, with which names, and what was wrong so far."""

    library: XacroLibrary
    found: Expansion = field(default_factory=Expansion)
    scope: XacroScope = field(default_factory=XacroScope)
    with_defaults: bool = False
    """Whether each argument has its default, and not any value."""

    def __post_init__(self) -> None:
        self.texts = TextEvaluator(self.undefined, self.undeclared)
        self.at = Context(Source("", ""), self.scope)

    def problem(self, kind: XacroProblem, span: Span, name: str, known: Iterable[str], macro: str = "") -> None:
        at, closed = self.at, not self.found.is_open
        told = FoundProblem(kind, at.source, span, name, frozenset(known), at.is_certain, closed, macro)
        if len(self.found.problems) < MAX_PROBLEMS and told not in self.found.problems:
            self.found.problems.append(told)

    def undefined(self, place: XacroPlace, name: str, scope: XacroScope) -> None:
        before, self.at = self.at, replace(self.at, source=place.source)
        self.problem(XacroProblem.NAME, place.span, name, scope.visible())
        self.at = before

    def undeclared(self, place: XacroPlace, name: str) -> None:
        before, self.at = self.at, replace(self.at, source=place.source)
        self.problem(XacroProblem.ARGUMENT, place.span, name, self.texts.arguments)
        self.at = before

    def evaluate(self, span: Span, context: Context) -> Value:
        self.at = context
        return self.texts.evaluate(XacroPlace(context.source, span), context.scope)
