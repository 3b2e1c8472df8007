"""Places of a Python file that nothing comes to any more, as another place always raises before."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile
from .nodes import FunctionNode, nodes_of, nodes_of_kind
from .raising_regions import bodies, body_of, raises_when_called, region_behind, unit_at
from .raising_statements import raising_statement

Definition = FunctionNode | ast.ClassDef


@dataclass(frozen=True, slots=True)
class NameUse:
    name: str
    place: int
    unit: int
    """The identity of the function that mentions it; 0 for the module."""
    is_own_call: bool
    """Whether it is called of `self`, or handed to a thread."""


@dataclass(frozen=True)
class StoppedPlaces:
    file: PythonFile
    stops: tuple[Span, ...]
    """What raises whenever it is come to, or does not return."""
    is_taken: Callable[[str], bool]
    """Whether other files read a name, so that they may come to what it names."""
    is_lasting: bool = False
    """Whether the stops are calls that don't return, during which callbacks run."""
    is_raising: bool = False
    """Whether each of them raises, and so leaves what is around it."""

    def has(self, place: int) -> bool:
        """Return whether a place is led to within the file, and each time something raises on the way."""
        here = self.unit(place)
        if here not in self.led_to_at_all:
            return False
        return here not in self.led_to or self.is_skipped(place)

    @cached_property
    def bodies(self) -> list[tuple[Span, FunctionNode]]:
        return bodies(self.file)

    def unit(self, place: int) -> int:
        """Return the identity of the function around a place; 0 for the module."""
        found = unit_at(self.bodies, place)
        return id(found) if found is not None else 0

    @cached_property
    def regions(self) -> tuple[Span, ...]:
        """What is skipped behind each stop, and behind each call of what always comes to one."""
        found: dict[Span, Span] = {}
        waiting = list(self.stops)
        while waiting:
            for stop in waiting:
                region = region_behind(self.file, unit_at(self.bodies, stop.start), stop)
                found |= {stop: region} if region is not None else {}
            outer = [each for stop in waiting if stop in found for each in self.raising_around(stop)]
            calls = [] if self.is_lasting else self.failing_calls({each.end for each in found.values()})
            waiting = [each for each in dict.fromkeys((*outer, *calls)) if each not in found and each not in waiting]
        return tuple(found.values())

    def raising_around(self, stop: Span) -> Iterator[Span]:
        """Yield the statement around a stop that raises as well."""
        scope = unit_at(self.bodies, stop.start) or self.file.tree
        outer = raising_statement(self.file, scope, stop, self.is_taken) if self.is_raising else None
        yield from [outer] if outer is not None else []

    def failing_calls(self, ends: set[int]) -> Iterator[Span]:
        """Yield the calls of functions whose rest is always skipped, and of classes whose `__init__` is such a one."""
        failing = {id(node) for span, node in self.bodies if span.end in ends and raises_when_called(node)}
        failing |= {id(owner) for owner in self.classes if any(id(each) in failing for each in starts_of(owner))}
        for call in nodes_of_kind(self.file.tree, ast.Call):
            definition = self.named.get(called_name(call), [])
            if definition and all(id(each) in failing for each in definition):
                yield self.file.span(call)

    @property
    def classes(self) -> list[ast.ClassDef]:
        return nodes_of_kind(self.file.tree, ast.ClassDef)

    def is_skipped(self, place: int) -> bool:
        return any(each.start <= place < each.end for each in self.regions)

    @cached_property
    def led_to_at_all(self) -> frozenset[int]:
        return self.reach(with_stops=False)

    @cached_property
    def led_to(self) -> frozenset[int]:
        return self.reach(with_stops=True)

    def reach(self, *, with_stops: bool) -> frozenset[int]:
        """Return the identities of the functions that are led to; that of the module is 0."""
        unborn = self.unborn if with_stops and not self.is_lasting else {}
        mentions = [each for each in self.mentions if not (with_stops and self.is_skipped(each.place))]
        is_started = not (with_stops and self.ends_module)
        found, waiting = {0}, [each for each in self.definitions if is_started and self.is_root(each)]
        known: set[int] = set()
        while True:
            for each in mentions:
                if each.unit in found:
                    waiting += [one for one in self.named.get(each.name, ()) if may_lead(each, one, unborn)]
            fresh = [each for each in waiting if id(each) not in known]
            if not fresh:
                return frozenset(found)
            known.update(map(id, fresh))
            found.update(id(each) for each in fresh if isinstance(each, FunctionNode))
            waiting = [one for each in fresh if isinstance(each, ast.ClassDef) for one in self.brought(each, unborn)]

    def brought(self, owner: ast.ClassDef, unborn: dict[int, frozenset[int]]) -> Iterator[FunctionNode]:
        """Yield the methods that come with an object of a class, whoever calls them."""
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

    @cached_property
    def definitions(self) -> tuple[Definition, ...]:
        return tuple(each for each in nodes_of(self.file.tree) if isinstance(each, Definition))

    @cached_property
    def named(self) -> dict[str, list[Definition]]:
        found: dict[str, list[Definition]] = {}
        for each in self.definitions:
            found.setdefault(each.name, []).append(each)
        return found

    @cached_property
    def methods(self) -> frozenset[int]:
        return frozenset(id(each) for owner in self.classes for each in owner.body)

    def is_root(self, each: Definition) -> bool:
        return id(each) not in self.methods and self.is_for_others(each)

    def is_for_others(self, each: Definition) -> bool:
        """Return whether others lead to a definition: its file does not, but for what stands in it itself."""
        inner = self.file.span(each)
        is_led_to = any(one.name == each.name and not inner.holds(Span(one.place, one.place)) for one in self.mentions)
        return not is_led_to or self.is_taken(each.name)

    @cached_property
    def unborn(self) -> dict[int, frozenset[int]]:
        """Each method of a class whose `__init__` always raises, with all methods of it."""
        found: dict[int, frozenset[int]] = {}
        for owner in self.classes:
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
        """Return whether a class below starts its objects without the `__init__` of another one."""
        heirs = (each for each in self.classes if owner.name in map(ast.unparse, each.bases))
        texts = (ast.unparse(start) for each in heirs for start in starts_of(each))
        return any("super(" not in text and f"{owner.name}.__init__" not in text for text in texts)

    @cached_property
    def mentions(self) -> Sequence[NameUse]:
        calls = {id(each.func) for each in nodes_of_kind(self.file.tree, ast.Call)}
        calls |= {id(each.value) for each in nodes_of_kind(self.file.tree, ast.keyword) if each.arg == "target"}
        return [
            self.mention(each, calls) for each in nodes_of(self.file.tree) if isinstance(each, ast.Name | ast.Attribute)
        ]

    def mention(self, node: ast.Name | ast.Attribute, calls: set[int]) -> NameUse:
        span = self.file.span(node)
        place = span.start if isinstance(node, ast.Name) else span.end - len(node.attr)
        is_own = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self"
        name = node.id if isinstance(node, ast.Name) else node.attr
        return NameUse(name, place, self.unit(place), is_own and id(node) in calls)


def called_name(call: ast.Call) -> str:
    """Return the name of a function or class, or of an own method, that is called; "" for any other."""
    match call.func:
        case ast.Name(id=name) | ast.Attribute(value=ast.Name(id="self"), attr=name):
            return name
    return ""


def starts_of(owner: ast.ClassDef) -> Iterator[FunctionNode]:
    return (each for each in owner.body if isinstance(each, FunctionNode) and each.name == "__init__")


def may_lead(mention: NameUse, to: Definition, unborn: dict[int, frozenset[int]]) -> bool:
    """Return whether a mention leads to a definition: to a method of an object that is never finished, its own call."""
    own = unborn.get(id(to))
    return own is None or (mention.is_own_call and mention.unit in own)
