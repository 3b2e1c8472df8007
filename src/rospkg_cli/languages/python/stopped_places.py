"""Places of a Python file that are never reached, as another place before them always raises."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...source import Span
from .definition_uses import Definition, DefinitionUses, NameUse
from .file import PythonFile
from .nodes import FunctionNode, nodes_of_kind
from .raising_regions import body_of, raises_when_called, region_behind, unit_at
from .raising_statements import raising_statement


@dataclass(frozen=True)
class StoppedPlaces:
    file: PythonFile
    stops: tuple[Span, ...]
    """What raises, or does not return, whenever it runs."""
    is_taken: Callable[[str], bool]
    """Whether other files read a name, and so may use what it names."""
    is_lasting: bool = False
    """Whether the stops are calls that don't return, during which callbacks run."""
    is_raising: bool = False
    """Whether each of them raises, and so ends the statements around it."""

    def has(self, place: int) -> bool:
        """Return whether the file has a way to a place, and something raises on each way."""
        here = self.uses.unit(place)
        if here not in self.led_to_at_all:
            return False
        return here not in self.led_to or self.is_skipped(place)

    @cached_property
    def uses(self) -> DefinitionUses:
        return DefinitionUses(self.file)

    @cached_property
    def regions(self) -> tuple[Span, ...]:
        """What is skipped behind each stop, and behind each call of a function that always reaches one."""
        found: dict[Span, Span] = {}
        waiting = list(self.stops)
        while waiting:
            for stop in waiting:
                region = region_behind(self.file, unit_at(self.uses.bodies, stop.start), stop)
                found |= {stop: region} if region is not None else {}
            outer = [each for stop in waiting if stop in found for each in self.raising_around(stop)]
            calls = [] if self.is_lasting else self.failing_calls({each.end for each in found.values()})
            waiting = [each for each in dict.fromkeys((*outer, *calls)) if each not in found and each not in waiting]
        return tuple(found.values())

    def raising_around(self, stop: Span) -> Iterator[Span]:
        """Yield the statement around a stop that raises as well."""
        scope = unit_at(self.uses.bodies, stop.start) or self.file.tree
        outer = raising_statement(self.file, scope, stop, self.is_taken) if self.is_raising else None
        yield from [outer] if outer is not None else []

    def failing_calls(self, ends: set[int]) -> Iterator[Span]:
        """Yield the calls of functions whose rest is always skipped, and of classes whose `__init__` is such a one."""
        failing = {id(node) for span, node in self.uses.bodies if span.end in ends and raises_when_called(node)}
        failing |= {id(owner) for owner in self.uses.classes if any(id(each) in failing for each in starts_of(owner))}
        for call in nodes_of_kind(self.file.tree, ast.Call):
            definition = self.uses.named.get(called_name(call), [])
            if definition and all(id(each) in failing for each in definition):
                yield self.file.span(call)

    def is_skipped(self, place: int) -> bool:
        return any(each.start <= place < each.end for each in self.regions)

    @cached_property
    def led_to_at_all(self) -> frozenset[int]:
        return self.reach(with_stops=False)

    @cached_property
    def led_to(self) -> frozenset[int]:
        return self.reach(with_stops=True)

    def reach(self, *, with_stops: bool) -> frozenset[int]:
        """Return the identities of the functions that the file reaches; that of the module is 0."""
        unborn = self.unborn if with_stops and not self.is_lasting else {}
        mentions = [each for each in self.uses.mentions if not (with_stops and self.is_skipped(each.place))]
        is_started = not (with_stops and self.ends_module)
        found, waiting = {0}, [each for each in self.uses.definitions if is_started and self.is_root(each)]
        known: set[int] = set()
        while True:
            for each in mentions:
                if each.unit in found:
                    waiting += [one for one in self.uses.named.get(each.name, ()) if may_lead(each, one, unborn)]
            fresh = [each for each in waiting if id(each) not in known]
            if not fresh:
                return frozenset(found)
            known.update(map(id, fresh))
            found.update(id(each) for each in fresh if isinstance(each, FunctionNode))
            waiting = [one for each in fresh if isinstance(each, ast.ClassDef) for one in self.brought(each, unborn)]

    def brought(self, owner: ast.ClassDef, unborn: dict[int, frozenset[int]]) -> Iterator[FunctionNode]:
        """Yield the methods of a class that others than this file may call on its objects."""
        for each in owner.body:
            if isinstance(each, FunctionNode):
                is_born = id(each) not in unborn or each.name == "__init__"
                if is_born and (each.name.startswith("__") or self.is_for_others(each)):
                    yield each

    @cached_property
    def ends_module(self) -> bool:
        """Whether the import of the file itself fails."""
        end = len(self.file.source.text)
        return not self.is_lasting and any(each.end == end for each in self.regions)

    def is_root(self, each: Definition) -> bool:
        return id(each) not in self.uses.methods and self.is_for_others(each)

    def is_for_others(self, each: Definition) -> bool:
        """Return whether other files may use a definition: its own file does not, or others read its name."""
        inner = self.file.span(each)
        is_led_to = any(
            one.name == each.name and not inner.holds(Span(one.place, one.place)) for one in self.uses.mentions
        )
        return not is_led_to or self.is_taken(each.name)

    @cached_property
    def unborn(self) -> dict[int, frozenset[int]]:
        """Each method of a class whose `__init__` always raises, with all methods of it."""
        found: dict[int, frozenset[int]] = {}
        for owner in self.uses.classes:
            own = [each for each in owner.body if isinstance(each, FunctionNode)]
            start = next(starts_of(owner), None)
            if (
                start is not None
                and not self.is_started_by_heir(owner)
                and any(each.end == body_of(self.file, start).end for each in self.regions)
            ):
                ids = frozenset(map(id, own))
                found |= {id(each): ids for each in own if not each.decorator_list and each is not start}
        return found

    def is_started_by_heir(self, owner: ast.ClassDef) -> bool:
        """Return whether a derived class has an `__init__` that does not call that of a class."""
        heirs = (each for each in self.uses.classes if owner.name in map(ast.unparse, each.bases))
        texts = (ast.unparse(start) for each in heirs for start in starts_of(each))
        return any("super(" not in text and f"{owner.name}.__init__" not in text for text in texts)


def called_name(call: ast.Call) -> str:
    """Return the name of a function or class, or of an own method, that is called; "" for any other."""
    match call.func:
        case ast.Name(id=name) | ast.Attribute(value=ast.Name(id="self"), attr=name):
            return name
    return ""


def starts_of(owner: ast.ClassDef) -> Iterator[FunctionNode]:
    return (each for each in owner.body if isinstance(each, FunctionNode) and each.name == "__init__")


def may_lead(mention: NameUse, to: Definition, unborn: dict[int, frozenset[int]]) -> bool:
    """Return whether a mention leads to a definition.

    Where the `__init__` of a class always raises, only calls by its own methods lead to a method.
    """
    own = unborn.get(id(to))
    return own is None or (mention.is_own_call and mention.unit in own)
