"""The state of a run of CMake files: variables, targets, the current frame, and the cost so far."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass, field
from ...unreadable import Unreadable
from .call_stack import (
    MAX_COST,
    MAX_DEPTH,
    MAX_STEPS,
    NOWHERE,
    ExhaustedError,
    Frame,
    FunctionDefinition,
    built_in,
)
from .evaluated_command import EvaluatedCommand, path_in_package
from .file import ROOT, CMakeFile
from .list_text import as_value
from .values import UNKNOWN, Value, Word, cost
from .variable_scope import Snapshot, VariableScope


@dataclass
class InterpreterState:
    files: PackageFiles
    calls: list[EvaluatedCommand] = field(default_factory=list)
    unreachable: list[EvaluatedCommand] = field(default_factory=list)
    """Commands that are never run, evaluated as far as possible."""
    broken: list[Unreadable] = field(default_factory=list)
    read: dict[str, CMakeFile] = field(default_factory=dict)
    scope: VariableScope = field(default_factory=VariableScope)
    functions: dict[str, FunctionDefinition] = field(default_factory=dict)
    targets: dict[str, bool] = field(default_factory=dict)
    """The targets that are certainly made, each with whether it is only for tests."""
    assigned: set[str] = field(default_factory=set)
    """Names of variables that a file of the package sets somewhere: before that they are empty."""
    possibly_assigned: set[str] = field(default_factory=set)
    """Variables that an unknown command may have set."""
    frame: Frame = field(default_factory=lambda: Frame(ROOT))
    assume: str | None = None
    """What BUILD_TESTING is while a condition is tried."""
    reads_unknown_files: bool = False
    """Files outside of the package were read: they may set any variable and make any target."""
    includes_unknown_files: bool = False
    """Not all of these were folders that are not there, which have a scope of their own."""
    steps: int = 0
    spent: int = 0
    """The cost of all words that were looked at or built so far."""
    stopped: str = ""
    """Why the run did not come to its end."""

    @contextmanager
    def enter_frame(self, frame: Frame) -> Iterator[None]:
        if frame.depth > MAX_DEPTH:
            raise ExhaustedError
        before, self.frame = self.frame, frame
        try:
            yield
        finally:
            self.frame = before

    def step(self) -> None:
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise ExhaustedError

    def spend(self, cost: int) -> None:
        """Count what something costs; raises ExhaustedError where the whole run costs too much."""
        self.spent += cost
        if self.spent > MAX_COST:
            raise ExhaustedError

    @cached_property
    def places(self) -> tuple[str, ...]:
        """All files and folders of the package, sorted."""
        return tuple(sorted(self.files.places))

    def save(self) -> Snapshot:
        """Return all variables as they are."""
        saved = self.scope.save()
        self.spend(sum(map(len, saved)) >> 3)
        return saved

    def unite(self, ends: Sequence[Snapshot]) -> None:
        """Merge the variables of several branches."""
        self.spend(self.scope.unite(ends))

    def value(self, name: str) -> Value:
        """Return the value of `${name}`; without one, empty if only the package sets it, else UNKNOWN."""
        found = self.value_if_set(name)
        if found is not None:
            return found
        return () if self.is_surely_unset(name) else self.unknown()

    def is_surely_unset(self, name: str) -> bool:
        """Return whether a variable that has no value yet is empty, because only the package itself sets it."""
        if self.reads_unknown_files or name in self.possibly_assigned or name.startswith("CMAKE_"):
            return False
        return name in self.assigned

    def value_if_set(self, name: str) -> Value | None:
        """Return the value of a variable that was set, or that CMake itself sets."""
        found = self.frame.bindings.get(name)
        if found is None:
            found = self.scope.get(name)
        if found is not None:
            self.spend(cost(found))
            return found
        if (text := built_in(name, self.frame, self.assume)) is not None:
            return as_value([self.word(text)])
        return None

    def word(self, text: str) -> Word:
        """Return a word without a position, made by CMake."""
        return Word(text, self.frame.path, NOWHERE)

    def unknown(self) -> Value:
        return (self.word(UNKNOWN),)

    def set(self, name: str, value: Value) -> None:
        self.spend(cost(value))
        if UNKNOWN not in name:
            self.scope.set(name, value)

    def set_text(self, name: str, text: str | None) -> None:
        """Set a variable to a text; None means UNKNOWN."""
        self.set(name, self.unknown() if text is None else as_value([self.word(text)]))

    def path(self, text: str) -> str | None:
        """Return a path relative to the package, None where it is unknown or outside."""
        return path_in_package(text, self.frame.folder)
