"""Evaluate a file from its first line to its last."""

from __future__ import annotations

from collections.abc import Mapping

from ...source import Span
from ..syntax import Syntax
from .bounds import LimitError
from .folder import ROOT, Folder
from .functions import Functions
from .library import LIBRARY
from .machine import Intrinsic
from .values import Argument, Call, Function, Scope, Text, Unknown, Value


class Evaluator(Functions):
    """A file that was evaluated: its names, and the calls that were left alone.

    `knows` adds functions to the library, by full name; each may return None to leave a call alone.
    """

    def __init__(
        self, file: Syntax, folder: Folder, knows: Mapping[str, Intrinsic] | None = None, *, name: str = "__main__"
    ) -> None:
        super().__init__(file, folder, {**LIBRARY, **(knows or {})})
        self.scope = Scope()
        self.scope.bind("__name__", Text(Span(0, 0), name))
        self.scope.bind("__file__", Text(Span(0, 0), f"{ROOT}/{file.path}"))
        self.gave_up = ""
        """Why the evaluation ended before the file did; "" where it did not."""

    def run_file(self) -> None:
        """Evaluate the file; never raises for what it holds."""
        try:
            self.execute(self.file.tree.body, self.scope)
        except LimitError as error:
            self.gave_up = str(error)
        except RecursionError:
            self.gave_up = "it is nested too deeply"

    def get(self, name: str) -> Value | None:
        """Return what a name of the file is bound to after its last line."""
        return self.scope.names.get(name)

    def call(self, function: Value, *arguments: Value, **named: Value) -> Value:
        """Call a function of the file; what it calls is added to `calls`. Never raises for what it holds."""
        span = function.span
        given = [*[("", value) for value in arguments], *named.items()]
        try:
            if isinstance(function, Function):
                call = Call(span, function.name, tuple(Argument(name, value, span) for name, value in given))
                return self.run(function, call)
            return self.apply(function, list(arguments), span)
        except LimitError as error:
            self.gave_up = str(error)
        except RecursionError:
            self.gave_up = "it is nested too deeply"
        return Unknown(span, self.gave_up)
