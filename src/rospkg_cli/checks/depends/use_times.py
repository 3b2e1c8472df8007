"""When a run of a program reaches a use of a name: at every start, in some runs, or never."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal, get_args

from ...languages.python.branches import is_under_condition
from ...languages.python.file import PythonFile
from ...languages.python.undefined_names import UndefinedName
from ...light_dataclasses import dataclass
from ...package.file_role import Role
from ...source import Span
from ..reached_places import ReachedPlaces

When = Literal["certainly", "maybe", "branch", "late", "ended", "unspun", "seldom", "unshown", "never", "aside"]
"""When a name is used: at every start or import, in some runs, under a condition or after another failure, behind a
`spin` that Ctrl-C leaves or the loop of a constructor, in a callback of a node that nothing spins, under several
conditions, where nothing is shown to come, where nothing leads, in what nothing installs."""

ORDER: tuple[When, ...] = get_args(When)


@dataclass(frozen=True)
class UseTimes:
    places: ReachedPlaces

    def of(self, role: Role, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        """Return when a use is reached; `certain` are the places that each start reaches."""
        if role == "test":
            return self.places.as_shown(file, found.span)
        return "aside" if role == "aside" else self.when(file, found, certain)

    def when(self, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        if found.span in certain and not (found.is_annotation or found.is_caught):
            return "certainly"
        return self.places.met(file, found.span)

    def of_attribute(self, role: Role, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        """Return when an attribute is read of an object, of which less is known than of a name."""
        when = self.of(role, file, found, certain)
        return "branch" if when == "maybe" and is_under_condition(file, found.span) else when
