"""Run the CMake files of a package without CMake, in bounded time; what can't be evaluated is unknown.

Platform and options are taken as on Linux. Where a condition can't be evaluated, all branches are run, and what they
did is marked as `maybe`. BUILD_TESTING is tried both ways.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ...light_dataclasses import dataclass, replace
from ...unreadable import UnreadableError
from .argument_words import words_of
from .call_stack import ExhaustedError, FunctionDefinition, LeaveError, environment
from .command_blocks import Block
from .evaluated_command import EvaluatedCommand
from .file import ROOT, CMakeFile, assigned_names, read_file
from .interpreter_state import InterpreterState
from .syntax import CommandInvocation
from .values import Word, cost


@dataclass(kw_only=True)
class Interpreter(InterpreterState):
    """Runs files; what commands and blocks do to the state is given, by name."""

    commands: Mapping[str, Callable[[Interpreter, EvaluatedCommand], None]]
    blocks: Mapping[str, Callable[[Interpreter, Block], None]]
    invoke: Callable[[Interpreter, FunctionDefinition, EvaluatedCommand], None]
    run_unknown_command: Callable[[Interpreter, EvaluatedCommand], None]
    """The effect of a command that is not CMake's."""
    own_name: str = ""
    """What project() is taken to be given where that can't be evaluated."""

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
        """Run a file of the package, in a given folder, or in that of the file that includes it."""
        file = self.load(path)
        if file is None:
            return
        where = self.frame.folder if folder is None else folder
        with self.enter_frame(replace(self.frame, path=path, file=path, folder=where, depth=self.frame.depth + 1)):
            try:
                self.body(file.body)
            except LeaveError as leave:
                if leave.how != "return":
                    raise

    def load(self, path: str) -> CMakeFile | None:
        if path in self.read:
            return self.read[path]
        if not self.files.has_file(path) or any(each.path == path for each in self.broken):
            return None
        try:
            self.read[path] = read_file(self.files, path)
        except UnreadableError as error:
            self.broken.append(error.unreadable)
            return None
        self.assigned |= set(assigned_names(self.read[path]))
        return self.read[path]

    # ---- commands

    def body(self, body: Sequence[CommandInvocation | Block]) -> None:
        for each in body:
            if isinstance(each, Block):
                self.step()
                self.blocks[each.command.name](self, each)
            else:
                self.command(each)

    def command(self, command: CommandInvocation) -> None:
        self.step()
        call = self.call(command)
        (self.unreachable if self.frame.is_unreachable else self.calls).append(call)
        if (function := self.functions.get(command.name)) is not None:
            self.invoke(self, function, call)
            return
        self.commands.get(command.name, self.run_unknown_command)(self, call)

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

    def run_unreachable(self, body: Sequence[CommandInvocation | Block]) -> None:
        """Run a body that is never run, only to record its commands; the state is restored."""
        saved, functions, targets = self.save(), dict(self.functions), dict(self.targets)
        try:
            with self.enter_frame(replace(self.frame, is_unreachable=True, depth=self.frame.depth + 1)):
                self.body(body)
        except LeaveError:
            pass
        finally:
            self.scope.restore(saved)
            self.functions, self.targets = functions, targets
