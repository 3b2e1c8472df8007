"""Evaluate a file from its first line to its last."""

from __future__ import annotations

from collections.abc import Mapping

from ....source import Span
from ..syntax import PythonSyntax
from .conversion import weight_of
from .functions import Functions
from .known_functions import LIBRARY
from .limits import LimitError
from .sandbox_filesystem import ROOT, SandboxFilesystem
from .state import Intrinsic
from .values import Argument, Call, Function, Namespace, Text, Unknown, Value

MAX_WEIGHT = 3_000_000
"""The limit for the values in the arguments of all calls, shared ones counted each time."""

GIVE_UP = (LimitError, RecursionError, MemoryError)


def reason(error: BaseException) -> str:
    """Return why an evaluation ended."""
    if isinstance(error, LimitError):
        return str(error)
    return "it is nested too deeply" if isinstance(error, RecursionError) else "it needs too much memory"


class Evaluator(Functions):
    """A file that was evaluated: its names, and the calls of unknown functions.

    `knows` adds functions to the library, by full name; each may return None to leave a call alone.
    """

    def __init__(
        self,
        file: PythonSyntax,
        folder: SandboxFilesystem,
        knows: Mapping[str, Intrinsic] | None = None,
        *,
        name: str = "__main__",
    ) -> None:
        super().__init__(file, folder, {**LIBRARY, **(knows or {})})
        self.scope = Namespace()
        self.scope.bind("__name__", Text(Span(0, 0), name))
        self.scope.bind("__file__", Text(Span(0, 0), f"{ROOT}/{file.path}"))
        self.weight = self.weighed = 0
        self.gave_up = ""
        """Why the evaluation ended before the file did; "" where it did not."""

    def run_file(self) -> None:
        """Evaluate the file; never raises for what it holds."""
        try:
            with self.meter.running():
                self.execute(self.file.tree.body, self.scope)
        except GIVE_UP as error:
            self.gave_up = reason(error)
        self.drop_vast_calls()

    def get(self, name: str) -> Value | None:
        """Return what a name of the file is bound to after its last line."""
        return self.scope.names.get(name)

    def call(self, function: Value, *arguments: Value, **named: Value) -> Value:
        """Call a function of the file; what it calls is added to `calls`. Never raises for what it holds."""
        span = function.span
        given = [*[("", value) for value in arguments], *named.items()]
        try:
            with self.meter.running():
                if isinstance(function, Function):
                    call = Call(span, function.name, tuple(Argument(name, value, span) for name, value in given))
                    found = self.run(function, call)
                else:
                    found = self.apply(function, list(arguments), span)
                self.charge_weight(found)
            return found
        except GIVE_UP as error:
            self.gave_up = reason(error)
        finally:
            self.drop_vast_calls()
        return Unknown(span, self.gave_up)

    def charge_weight(self, value: Value) -> None:
        """Raise LimitError where values share each other so often that reading them would not end."""
        self.weight += weight_of(value, MAX_WEIGHT - self.weight)
        if self.weight > MAX_WEIGHT:
            raise LimitError("what it builds is too large")

    def drop_vast_calls(self) -> None:
        """Drop the calls from the first one on whose arguments are too large, and give up."""
        try:
            while self.weighed < len(self.calls):
                self.charge_weight(self.calls[self.weighed])
                self.weighed += 1
        except LimitError as error:
            del self.calls[self.weighed :]
            self.gave_up = self.gave_up or reason(error)
