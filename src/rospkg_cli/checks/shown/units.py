"""What a function or a module runs by itself, with the conditions of each part, and where it stands."""

from __future__ import annotations

import ast
from functools import cached_property

from ...languages.python.counted_conditions import Counted, counted
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, children_of, functions_of
from ...light_dataclasses import dataclass
from ...source import Span
from .meanings import Own

BLOCKS = ("body", "orelse", "finalbody")


@dataclass(frozen=True, slots=True)
class Place:
    """Where a function stands."""

    owner: Own | None
    """The class whose object its `self` is: of the method around, too."""
    inner: dict[str, Own]
    """The functions that it, and the functions around it, define for themselves."""


class Units:
    """The units of a run, kept."""

    @cached_property
    def _parts(self) -> dict[tuple[int, bool], list[Counted]]:
        return {}

    def parts(self, unit: Own, *, is_program: bool = False) -> list[Counted]:
        """Return the nodes that a unit runs, without the functions in it."""
        if (unit.key, is_program) not in self._parts:
            found = counted(unit.node.body, unit.file.constants, is_program=is_program)
            self._parts[unit.key, is_program] = [*found]
        return self._parts[unit.key, is_program]

    @cached_property
    def _places(self) -> dict[str, dict[int, Place]]:
        return {}

    def place(self, unit: Own) -> Place:
        if unit.file.path not in self._places:
            self._places[unit.file.path] = places_in(unit.file)
        return self._places[unit.file.path].get(unit.key, Place(None, {}))

    def conditions(self, unit: Own, span: Span, *, is_program: bool = False) -> int | None:
        """Return how many conditions of a unit must hold before a place runs; None where it never does."""
        smallest, found, around = len(unit.file.source.text) + 1, None, None
        for node, conditions in self.parts(unit, is_program=is_program):
            if isinstance(node, ast.stmt | ast.expr | ast.ExceptHandler | ast.keyword):
                at = unit.file.span(node)
                if at.holds(span) and at.end - at.start <= smallest:
                    smallest, found, around = at.end - at.start, conditions, node
        return None if around is not None and is_in_block(unit.file, around, span) else found


def is_in_block(file: PythonFile, node: ast.AST, span: Span) -> bool:
    """Return whether a place is in a part of a node that is one of its own where it runs: a statement, an operand."""
    if isinstance(node, ast.IfExp | ast.BoolOp):
        return any(isinstance(each, ast.expr) and file.span(each).holds(span) for each in children_of(node))
    blocks = (getattr(node, name, ()) for name in BLOCKS)
    inner = (each for block in blocks if isinstance(block, list) for each in block if isinstance(each, ast.stmt))
    return any(file.span(each).holds(span) for each in inner)


def unit_around(file: PythonFile, span: Span) -> Own:
    """Return the innermost function whose body holds a place, or the module."""
    around = [each for each in functions_of(file.tree) if file.span(each).holds(span)]
    around = [each for each in around if file.span(each.body[0]).start <= span.start]
    return Own(file, max(around, key=lambda each: file.span(each).start) if around else file.tree)


def is_in_function(file: PythonFile, span: Span) -> bool:
    return not isinstance(unit_around(file, span).node, ast.Module)


def places_in(file: PythonFile) -> dict[int, Place]:
    found: dict[int, Place] = {}
    waiting: list[tuple[ast.AST, Place, bool]] = [(each, Place(None, {}), False) for each in file.tree.body]
    while waiting:
        node, place, is_member = waiting.pop()
        if isinstance(node, ast.ClassDef):
            waiting += [(each, Place(Own(file, node), place.inner), True) for each in node.body]
        elif isinstance(node, FunctionNode):
            own = {each.name: Own(file, each) for each in node.body if isinstance(each, FunctionNode)}
            found[id(node)] = Place(place.owner, {**place.inner, **own})
            waiting += [(each, found[id(node)], False) for each in node.body]
        elif isinstance(node, ast.stmt | ast.ExceptHandler | ast.match_case):
            waiting += [(each, place, is_member) for each in children_of(node)]
    return found
