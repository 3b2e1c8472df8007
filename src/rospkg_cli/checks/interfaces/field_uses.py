"""Rule input: uses of unknown fields in Python code, and whether each of them runs (IDL010)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...source import Span
from ..fault import Level
from ..python.run_imports import RunImports
from ..reached_definitions import ReachedDefinitions
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..repository.older_distribution import OlderDistribution
from .annotated_parameters import is_by_annotation_alone
from .idle_objects import IdleObjects
from .known_interfaces import KnownInterfaces
from .seldom_run import is_called_with_care, is_in_handler, is_replaced
from .uncalled_methods import UncalledMethods
from .unknown_fields import CATCHES, UnknownField, UnknownFields


@dataclass(frozen=True)
class FieldUses:
    known: KnownInterfaces
    run: RunImports
    reached: ReachedModules | None = None
    definitions: ReachedDefinitions | None = None
    distribution: OlderDistribution | None = None
    places: ReachedPlaces | None = None

    def unknown(self) -> Iterator[UnknownField]:
        """Yield the unknown fields of each file, in the order of its text."""
        return UnknownFields(self.known, self.run).unknown()

    def level_of(self, use: UnknownField) -> Level | None:
        """Return the level of a keyword that a message does not have: it raises up to Iron, and is ignored later.

        It is None (the rule's own level) where the pages name no distribution from Jazzy on, and for a field that code
        sets or reads: that always raises.
        """
        if not use.is_keyword or self.distribution is None or self.distribution.is_before_jazzy:
            return None
        return "info" if self.distribution.is_from_jazzy_on else "warning"

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing starts or imports, in a package that has programs."""
        return self.reached is not None and self.reached.is_left(path)

    @cached_property
    def uncalled(self) -> UncalledMethods:
        return UncalledMethods(self.run)

    def is_uncalled(self, use: UnknownField) -> bool:
        """Return whether a use is in a method that no code of the package names."""
        return self.uncalled.has(use.path, use.span)

    @cached_property
    def idle(self) -> IdleObjects:
        return IdleObjects(self.run)

    def is_idle(self, use: UnknownField) -> bool:
        """Return whether a use is in a method of an object that is created and never used."""
        return self.idle.has(use.path, use.span)

    def is_unreached(self, use: UnknownField) -> bool:
        """Return whether no program of the package calls the function around a use."""
        return self.places is not None and self.is_so(self.places.is_idle, use)

    def is_late(self, use: UnknownField) -> bool:
        """Return whether a use follows a `spin` that Ctrl-C ends."""
        return self.places is not None and self.is_so(self.places.is_late, use)

    def is_ended(self, use: UnknownField) -> bool:
        """Return whether a use follows the loop of a constructor."""
        return self.places is not None and self.is_so(self.places.is_ended, use)

    def is_unspun(self, use: UnknownField) -> bool:
        """Return whether a use is in a callback of a node that nothing spins."""
        return self.places is not None and self.is_so(self.places.shown.is_unspun, use)

    def is_by_path(self, use: UnknownField) -> bool:
        """Return whether a use runs only where a module is started by its path, though an entry point starts it too."""
        return self.places is not None and self.is_so(self.places.is_by_path, use)

    def is_turned_off(self, use: UnknownField) -> bool:
        """Return whether a use is under a condition that is off, and that nothing switches on."""
        if self.places is not None and self.is_so(self.places.is_off, use):
            return True
        return self.definitions is not None and self.is_so(self.definitions.is_turned_off, use)

    def is_conditional(self, use: UnknownField) -> bool:
        """Return whether a use is in a branch of its function."""
        return self.places is not None and self.places.is_conditional(use.path, use.span)

    def conditions(self, use: UnknownField) -> int | None:
        """Return the number of conditions on the shortest known way from a program to a use; None without a way."""
        file = self.run.modules.at(use.path)
        return self.places.conditions(file, use.span) if file is not None and self.places is not None else None

    def is_unshown(self, use: UnknownField) -> bool:
        """Return whether no way from a program to a use is known."""
        return self.conditions(use) is None

    def is_seldom(self, use: UnknownField) -> bool:
        """Return whether each known way to a use has several conditions, or none is known."""
        return self.is_under(use, 2)

    def is_at_times(self, use: UnknownField) -> bool:
        """Return whether each known way to a use has a condition, or none is known."""
        return self.is_under(use, 1)

    def is_under(self, use: UnknownField, least: int) -> bool:
        conditions = self.conditions(use)
        return conditions is None or conditions >= least

    def is_in_handler(self, use: UnknownField) -> bool:
        """Return whether a use is in an `except` branch."""
        return self.is_so(is_in_handler, use)

    def is_called_with_care(self, use: UnknownField) -> bool:
        """Return whether a use is in a function whose callers catch what it raises."""
        return self.is_so(lambda file, span: is_called_with_care(file, span, CATCHES), use)

    def is_by_word(self, use: UnknownField) -> bool:
        """Return whether only an annotation says what type a use is of, in a function that other code may call."""
        running = self.run.running
        return self.is_so(lambda file, span: is_by_annotation_alone(file, span, use.message, running), use)

    def is_replaced(self, use: UnknownField) -> bool:
        """Return whether a use is in a class that the module defines again further down."""
        return self.is_so(is_replaced, use)

    def is_so(self, of_place: Callable[[PythonFile, Span], bool], use: UnknownField) -> bool:
        """Return what a question about a place of a file answers for a use; False where its file is no module."""
        file = self.run.modules.at(use.path)
        return file is not None and of_place(file, use.span)
