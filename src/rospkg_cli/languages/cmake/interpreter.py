"""Run the CMake files of a package as far as that can be done without CMake: bounded, and honest about holes.

What platforms and options decide is judged as on Linux; conditions that can't be evaluated run all their branches,
and what they did is then marked as `maybe`.  BUILD_TESTING is tried both ways.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property

from ...files import PackageFiles
from ...unreadable import Unreadable, UnreadableError
from .call_stack import (
    MAX_COST,
    MAX_DEPTH,
    MAX_STEPS,
    NOWHERE,
    ExhaustedError,
    Frame,
    FunctionDefinition,
    LeaveError,
    built_in,
    environment,
)
from .command_blocks import Block
from .evaluated_command import EvaluatedCommand, located
from .file import ROOT, CMakeFile, names_set, read_file
from .syntax import CommandInvocation
from .values import UNKNOWN, Value, Word, as_value, cost, words_of
from .variable_scope import Snapshot, VariableScope


@dataclass
class Interpreter:
    """The state of a run; what commands and blocks do to it is given, by name."""

    files: PackageFiles
    commands: Mapping[str, Callable[[Interpreter, EvaluatedCommand], None]]
    blocks: Mapping[str, Callable[[Interpreter, Block], None]]
    invoke: Callable[[Interpreter, FunctionDefinition, EvaluatedCommand], None]
    foreign: Callable[[Interpreter, EvaluatedCommand], None]
    """What a command does that is none of CMake's own."""
    calls: list[EvaluatedCommand] = field(default_factory=list)
    idle: list[EvaluatedCommand] = field(default_factory=list)
    """Commands that are never run, evaluated as far as that goes."""
    broken: list[Unreadable] = field(default_factory=list)
    read: dict[str, CMakeFile] = field(default_factory=dict)
    scope: VariableScope = field(default_factory=VariableScope)
    functions: dict[str, FunctionDefinition] = field(default_factory=dict)
    targets: dict[str, bool] = field(default_factory=dict)
    """The targets that are certainly made, each with whether it is only for tests."""
    assigned: set[str] = field(default_factory=set)
    """Names of variables that a file of the package sets somewhere: before that they are empty."""
    touched: set[str] = field(default_factory=set)
    """Names that a command which we don't know may have set."""
    frame: Frame = field(default_factory=lambda: Frame(ROOT))
    assume: str | None = None
    """What BUILD_TESTING is while a condition is tried."""
    clouded: bool = False
    """Something was read that we can't see: it may have set any variable, and made any target."""
    steps: int = 0
    spent: int = 0
    """The cost of all words that were looked at or built so far."""
    stopped: str = ""
    """Why the run did not come to its end."""

    def run(self) -> None:
        """Run CMakeLists.txt; never raises for what it holds."""
        try:
            self.file(ROOT)
        except LeaveError as leave:
            self.stopped = "`message(FATAL_ERROR …)` stops it" if leave.how == "fatal" else ""
        except (ExhaustedError, RecursionError):
            self.stopped = "it takes too many steps"

    # ---- files

    def file(self, path: str, folder: str | None = None) -> None:
        """Run a file of the package, in the folder of the one that includes it or in its own."""
        file = self.load(path)
        if file is None:
            return
        where = self.frame.folder if folder is None else folder
        with self.framed(replace(self.frame, path=path, file=path, folder=where, depth=self.frame.depth + 1)):
            try:
                self.body(file.body)
            except LeaveError as leave:
                if leave.how != "return":
                    raise

    def load(self, path: str) -> CMakeFile | None:
        if path in self.read:
            return self.read[path]
        if not self.files.holds(path) or any(each.path == path for each in self.broken):
            return None
        try:
            self.read[path] = read_file(self.files, path)
        except UnreadableError as error:
            self.broken.append(error.unreadable)
            return None
        self.assigned |= set(names_set(self.read[path]))
        return self.read[path]

    @contextmanager
    def framed(self, frame: Frame) -> Iterator[None]:
        if frame.depth > MAX_DEPTH:
            raise ExhaustedError
        before, self.frame = self.frame, frame
        try:
            yield
        finally:
            self.frame = before

    # ---- commands

    def body(self, body: Sequence[CommandInvocation | Block]) -> None:
        for each in body:
            if isinstance(each, Block):
                self.step()
                self.blocks[each.command.name](self, each)
            else:
                self.command(each)

    def step(self) -> None:
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise ExhaustedError

    def spend(self, cost: int) -> None:
        """Count what something costs; raises ExhaustedError where the whole run costs too much."""
        self.spent += cost
        if self.spent > MAX_COST:
            raise ExhaustedError

    def command(self, command: CommandInvocation) -> None:
        self.step()
        call = self.call(command)
        (self.idle if self.frame.idle else self.calls).append(call)
        if (function := self.functions.get(command.name)) is not None:
            self.invoke(self, function, call)
            return
        self.commands.get(command.name, self.foreign)(self, call)

    def call(self, command: CommandInvocation) -> EvaluatedCommand:
        frame = self.frame
        found = self.by_argument(command)
        words, counts = tuple(word for each in found for word in each), tuple(map(len, found))
        self.spend(cost(words))
        return EvaluatedCommand(
            command, words, frame.path, frame.folder, frame.testing, frame.maybe, frame.inside, counts
        )

    def words(self, command: CommandInvocation) -> list[Word]:
        """Return the evaluated arguments of a command."""
        return [word for each in self.by_argument(command) for word in each]

    def by_argument(self, command: CommandInvocation) -> list[list[Word]]:
        return [words_of(argument, self.frame.path, self.value, environment) for argument in command.arguments]

    def try_out(self, body: Sequence[CommandInvocation | Block]) -> None:
        """Run what is never run, only to see its commands: nothing of what it does stays."""
        saved, functions, targets = self.save(), dict(self.functions), dict(self.targets)
        try:
            with self.framed(replace(self.frame, idle=True, depth=self.frame.depth + 1)):
                self.body(body)
        except LeaveError:
            pass
        finally:
            self.scope.restore(saved)
            self.functions, self.targets = functions, targets

    # ---- variables

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
        """Take over what is common to the ends of several branches."""
        self.spend(self.scope.unite(ends))

    def value(self, name: str) -> Value:
        """Return what `${name}` stands for: nothing, where the package itself has yet to set it; else a hole."""
        found = self.known(name)
        if found is not None:
            return found
        return () if self.settled(name) else self.hole()

    def settled(self, name: str) -> bool:
        """Return whether a variable that has no value yet is empty, because only the package itself sets it."""
        if self.clouded or name in self.touched or name.startswith("CMAKE_"):
            return False
        return name in self.assigned

    def known(self, name: str) -> Value | None:
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
        """Return a word that stands nowhere: CMake made it."""
        return Word(text, self.frame.path, NOWHERE)

    def hole(self) -> Value:
        return (self.word(UNKNOWN),)

    def set(self, name: str, value: Value) -> None:
        self.spend(cost(value))
        if UNKNOWN not in name:
            self.scope.set(name, value)

    def set_text(self, name: str, text: str | None) -> None:
        """Set a variable to a text, or to a hole."""
        self.set(name, self.hole() if text is None else as_value([self.word(text)]))

    def path(self, text: str) -> str | None:
        """Return a path relative to the package, None where it is unknown or outside."""
        return located(text, self.frame.folder)
