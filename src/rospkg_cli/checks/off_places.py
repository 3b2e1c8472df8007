"""Rule input: places of Python that run only with a parameter, an option or a variable which is off."""

from __future__ import annotations

import ast
from functools import cached_property

from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, functions_of, nodes_of_kind
from ..light_dataclasses import dataclass
from ..source import Span
from .unset_switches import UnsetSwitches

MOST = 3
"""How many functions may stand between a switch and a place."""
ENTRIES = frozenset({"main", "generate_launch_description"})

Place = tuple[PythonFile, Span]


@dataclass(frozen=True)
class OffPlaces:
    switches: UnsetSwitches

    def has(self, file: PythonFile, span: Span) -> bool:
        """Return whether a switch is around a place, or around all that names the function which it is in."""
        if (file.path, span) not in self.found:  # several rules ask of one place
            self.found[file.path, span] = self.is_led_to(file, span)
        return self.found[file.path, span]

    @cached_property
    def found(self) -> dict[tuple[str, Span], bool]:
        return {}

    def is_led_to(self, file: PythonFile, span: Span) -> bool:
        """Return the same, asked anew."""
        places: list[Place] = [(file, span)]
        for _ in range(MOST):
            places = [place for place in places if not self.switches.why_off(place[0].path, place[1])]
            if not places:
                return True
            found = [self.leading_to(*place) for place in places]
            if not all(found):
                return False
            places = [place for each in found for place in each]
        return False

    def leading_to(self, file: PythonFile, span: Span) -> list[Place]:
        """Return where code names the function around a place, but for the function itself; nothing where others do."""
        around = self.around(file, span)
        if around is None or around.name in ENTRIES or around.name.startswith("__"):
            return []
        own = file.span(around)
        return [(other, at) for other, at in self.naming.get(around.name, []) if other is not file or not own.holds(at)]

    def around(self, file: PythonFile, span: Span) -> FunctionNode | None:
        """Return the outermost function around a place."""
        return next((each for each in functions_of(file.tree) if file.span(each).holds(span)), None)

    @cached_property
    def naming(self) -> dict[str, list[Place]]:
        """By each name that code of the package has, where it stands, but for where a function of it is defined."""
        found: dict[str, list[Place]] = {}
        for _, file in self.switches.run.files:
            for each in nodes_of_kind(file.tree, ast.Attribute):
                found.setdefault(each.attr, []).append((file, file.span(each)))
            for name in nodes_of_kind(file.tree, ast.Name):
                found.setdefault(name.id, []).append((file, file.span(name)))
        return found
