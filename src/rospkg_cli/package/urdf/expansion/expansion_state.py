"""Where the expansion of a robot is, and the problems that it found so far."""

from __future__ import annotations

from collections.abc import Iterable

from ....languages.xml.parser import Element
from ....light_dataclasses import dataclass, field, replace
from ....source import Source, Span
from .expansion import Expansion, FoundProblem, Node, XacroProblem
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
    """The state of an expansion: the place, the names in scope, and the problems so far."""

    library: XacroLibrary
    found: Expansion = field(default_factory=Expansion)
    scope: XacroScope = field(default_factory=XacroScope)
    with_defaults: bool = False
    """Whether each argument has its default value; otherwise its value is not known."""

    def __post_init__(self) -> None:
        self.texts = TextEvaluator(self.undefined, self.undeclared)
        self.at = Context(Source("", ""), self.scope)

    def inside(self, element: Element, into: list[Node], context: Context) -> None:
        """Expand the children of an element, and add them to a list; `Expander` does."""
        raise NotImplementedError

    def element(self, element: Element, into: list[Node], context: Context) -> None:
        """Expand one element, and add what it becomes to a list; `Expander` does."""
        raise NotImplementedError

    def problem(self, kind: XacroProblem, span: Span, name: str, known: Iterable[str], macro: str = "") -> None:
        at, closed = self.at, not self.found.is_open
        problem = FoundProblem(kind, at.source, span, name, frozenset(known), at.is_certain, closed, macro)
        if len(self.found.problems) < MAX_PROBLEMS and problem not in self.found.problems:
            self.found.problems.append(problem)

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
