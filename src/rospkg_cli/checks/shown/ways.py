"""Rule input: by how many conditions, at least, a program is shown to come to a line of Python code."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cached_property
from heapq import heappop, heappush

from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...source import Span
from .meanings import Meanings, Own
from .own_objects import OwnObjects, functions_in
from .spun_callbacks import without_callbacks
from .starts import Start, Starts
from .steps import Step, Steps
from .units import Units, unit_around

Reached = dict[tuple[int, bool], int]
BORN = ("__init__", "__new__", "__post_init__", "__init_subclass__")
"""What runs wherever an object is made."""
HOOKS = {
    "Thread": ("run",), "QThread": ("run",), "QRunnable": ("run",), "Process": ("run",), "Timer": ("run",),
    "LifecycleNode": ("on_configure", "on_activate", "on_deactivate", "on_cleanup", "on_shutdown", "on_error"),
    "Behaviour": ("setup", "initialise", "update", "terminate"), "State": ("execute",), "Module": ("forward",),
    "BaseHTTPRequestHandler": ("do_GET", "do_POST"),
}  # fmt: skip
"""What classes of others call of their heirs."""


@dataclass(frozen=True)
class ShownWays:
    starts: Starts

    def conditions(self, file: PythonFile, span: Span) -> int | None:
        """Return how many conditions lie on the shortest way that is shown to a place; None where none is shown."""
        return self.conditions_from(self.reached, file, span)

    def is_for_tests(self, file: PythonFile, span: Span) -> bool:
        """Return whether ways from tests alone are shown to a place."""
        is_shown = self.conditions(file, span) is not None
        return is_shown and self.conditions_from(self.reached_without_tests, file, span) is None

    def is_unspun(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is come to in callbacks alone, of programs in which nothing spins a node."""
        reached = self.reached_where_spun
        return reached is not self.reached and self.conditions_from(reached, file, span) is None

    def conditions_from(self, reached: Reached, file: PythonFile, span: Span) -> int | None:
        unit = unit_around(file, span)
        found = []
        for is_program in (False, True):
            before = reached.get((unit.key, is_program))
            inside = self.units.conditions(unit, span, is_program=is_program) if before is not None else None
            found += [before + inside] if before is not None and inside is not None else []
        return min(found, default=None)

    def conditions_in_module(self, file: PythonFile, span: Span) -> int | None:
        """Return how many conditions a place at the top level of a module has, where that is imported."""
        return self.units.conditions(Own(file, file.tree), span)

    @cached_property
    def units(self) -> Units:
        return Units()

    @cached_property
    def objects(self) -> OwnObjects:
        return OwnObjects(self.meanings)

    @cached_property
    def meanings(self) -> Meanings:
        return Meanings(self.starts.run, self.starts.installed)

    @cached_property
    def reached(self) -> Reached:
        return self.reached_from(self.starts.all(self.meanings))

    @cached_property
    def reached_without_tests(self) -> Reached:
        return self.reached_from(self.starts.all(self.meanings, with_tests=False))

    @cached_property
    def reached_where_spun(self) -> Reached:
        """What is reached without the callbacks of programs in which nothing spins a node."""
        from .spins import Spins  # what few packages need, and each start would pay for

        spins, starts = Spins(Steps(self.meanings, self.objects, self.units)), [*self.starts.all(self.meanings)]
        still = [each for each in starts if each.is_whole and not spins.may_be_in(each.unit.file)]
        if not still:
            return self.reached
        others = self.reached_from(each for each in starts if each not in still)
        return others | self.reached_from(still, is_spun=False)

    def reached_from(self, starts: Iterable[Start], *, is_spun: bool = True) -> Reached:
        """Return the conditions on the way to each function, class and module; as a program, too."""
        steps, made = Steps(self.meanings, self.objects, self.units), set[tuple[int, bool]]()
        found: Reached = {}
        pending: dict[tuple[int, bool], list[tuple[Own, int]]] = {}
        heap = Heap()
        for start in starts:
            heap.push(start)
        while heap.has_more:
            start = heap.pop()
            unit, conditions = start.unit, start.conditions
            if (unit.key, start.is_program) in found:
                continue
            found[unit.key, start.is_program] = conditions
            if isinstance(unit.node, ast.ClassDef):
                for key in ((unit.key, True), *((each.key, False) for each in self.objects.line(unit))):
                    made.add(key)
                    for one, count in pending.pop(key, ()):
                        heap.push(Start(one, max(count, conditions)))
                for one in self.born(unit):
                    heap.push(Start(one, conditions))
                continue
            for step, count in self.steps_of(steps, start, is_spun=is_spun):
                needed = (step.needs.key, step.is_exact) if step.needs is not None else None
                if needed is not None and needed not in made:
                    pending.setdefault(needed, []).append((step.to, conditions + count))
                else:
                    heap.push(Start(step.to, conditions + count))
        return found

    def steps_of(self, steps: Steps, start: Start, *, is_spun: bool) -> Iterator[tuple[Step, int]]:
        handed: set[int] = set()
        parts = self.units.parts(start.unit, is_program=start.is_program)
        for node, conditions in parts if is_spun else without_callbacks(parts, start.unit.file):
            for step in steps.of(start.unit, node, handed):
                yield step, conditions + step.more

    def born(self, owner: Own) -> Iterator[Own]:
        """Yield the functions that run where an object of a class is made, or that classes of others call of it."""
        for name in BORN:
            found = self.objects.member(owner, name)
            yield from [found] if found is not None else []
        above = {ast.unparse(base).rpartition(".")[2] for each in self.objects.line(owner) for base in bases(each)}
        hooks = {name for base in above for name in HOOKS.get(base, ())}
        for each in self.objects.line(owner):
            is_gui = any(base.startswith("Q") for base in above)
            for one in functions_in(each):
                if one.name in hooks or (is_gui and one.name.endswith("Event")):
                    yield Own(each.file, one)


def bases(owner: Own) -> list[ast.expr]:
    return owner.node.bases if isinstance(owner.node, ast.ClassDef) else []


class Heap:
    """Starts, those with the fewest conditions first."""

    def __init__(self) -> None:
        self.waiting: list[tuple[int, int, Start]] = []
        self.pushed = 0

    def push(self, start: Start) -> None:
        self.pushed += 1
        heappush(self.waiting, (start.conditions, self.pushed, start))

    def pop(self) -> Start:
        return heappop(self.waiting)[2]

    @property
    def has_more(self) -> bool:
        return bool(self.waiting)
