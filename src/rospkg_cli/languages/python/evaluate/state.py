"""The state of an evaluation, as known functions use it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager

from ....source import Span
from ..syntax import PositionedNode, PythonSyntax
from .limits import MAX_ITEMS, STEP, CostMeter, LimitError, spend
from .sandbox_filesystem import ROOT, SandboxFilesystem
from .values import Call, Function, GlobResult, Sequence, Unknown, Value
from .values import Mapping as MappingValue

Intrinsic = Callable[["EvaluationState", Call], "Value | None"]
"""A function that the evaluator knows; it returns None to leave the call alone."""


MAX_SHOWN = 1_000
"""Characters of the file that are looked at to show the first 60 of them."""


class EvaluationState(ABC):
    def __init__(self, file: PythonSyntax, folder: SandboxFilesystem, library: Mapping[str, Intrinsic]) -> None:
        self.file = file
        self.folder = folder
        self.library = library
        self.cwd = ROOT
        self.meter = CostMeter()
        self.calls: list[Call] = []
        """Every call of an unknown function, in order."""
        self.globs: list[GlobResult] = []
        self.conditions: list[str] = []
        """Why it is unknown whether the current code runs; empty where it certainly runs."""
        self.unknown_count = 0
        """How many unknown values there were so far: a `try` whose body adds none does not raise."""
        self.fixed: Span | None = None
        """The span for all nodes inside an f-string, where older parsers count wrongly."""

    def tick(self, steps: int = 1) -> None:
        """Charge for steps; raises LimitError where there are too many."""
        spend(steps * STEP)

    @property
    def steps(self) -> int:
        """How many steps were taken, or what was built instead of them."""
        return self.meter.cost // STEP

    def span(self, node: PositionedNode) -> Span:
        return self.fixed or self.file.span(node)

    @property
    def certain(self) -> bool:
        return not self.conditions

    @contextmanager
    def assuming(self, why: str) -> Iterator[None]:
        """Evaluate code that may not run at all."""
        self.conditions.append(why)
        try:
            yield
        finally:
            self.conditions.pop()

    def unknown(self, span: Span, why: str, *, many: bool = False, options: tuple[Value, ...] = ()) -> Unknown:
        self.unknown_count += 1
        return Unknown(span, why, many, options)

    def quoted(self, span: Span) -> str:
        """Return the text at a span in one short line, in backticks."""
        begin = Span(span.start, min(span.end, span.start + MAX_SHOWN))
        text = " ".join(self.file.source.slice(begin).split())
        return f"`{text}`" if len(text) <= 60 and begin == span else f"`{text[:57]}…`"

    def computed_list(self, span: Span, items: list[Value]) -> Sequence:
        """Return a list that was computed, not written."""
        if len(items) > MAX_ITEMS:
            raise LimitError(f"a list of more than {MAX_ITEMS} items")
        self.tick(len(items))
        return Sequence(span, "list", items, [span] * len(items), open_conditions=len(self.conditions))

    def add_item(self, into: Sequence, item: Value, place: Span) -> None:
        """Add an item to a list, certainly or possibly."""
        self.tick()
        if len(into.items) >= MAX_ITEMS:
            raise LimitError(f"a list of more than {MAX_ITEMS} items")
        if len(self.conditions) > into.open_conditions and not (isinstance(item, Unknown) and item.is_many):
            item = self.unknown(place, self.conditions[-1], many=True, options=(item,))
        into.add(item, place)

    def mark_unknown(self, value: Value, span: Span, why: str) -> None:
        """Mark a list or dict as partly unknown, after a change that can't be followed."""
        if isinstance(value, Sequence):
            value.add(self.unknown(span, why, many=True), span)
        elif isinstance(value, MappingValue):
            value.rest.append(self.unknown(span, why, many=True))

    @abstractmethod
    def apply(self, function: Value, arguments: list[Value], span: Span) -> Value:
        """Call a value with positional arguments."""

    @abstractmethod
    def run(self, function: Function, call: Call) -> Value:
        """Return what a function of the file returns."""
