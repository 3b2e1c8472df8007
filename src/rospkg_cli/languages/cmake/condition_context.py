"""What conditions can test about the package and the state of the interpreter."""

from __future__ import annotations

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .call_stack import IS_SET
from .interpreter import Interpreter
from .truth import Truth
from .values import BINARY, PREFIX, UNKNOWN, Value

OLDEST_POLICY = "CMP0128"
"""The last that Ubuntu 22.04's CMake knows: what is newer may be unknown to the one that builds."""

IDENTIFIER = regex(r"[A-Za-z_][\w.:+-]*")

FROM_OUTSIDE = regex(r"[A-Z][A-Z0-9]*_[A-Z0-9_]+|\w+_[A-Z]+_*")
"""What may be set by CMake, by its user, or by another package: `CMAKE_BUILD_TYPE`, `rclcpp_VERSION`.

Linear: of all ways to part a name such as `a_B_C`, only the last is tried to its end.
"""


@dataclass
class InterpreterContext:
    interpreter: Interpreter

    def variable(self, name: str) -> Value | None:
        """Return a variable's value; None where it is not set, UNKNOWN where that is unknown."""
        found = self.interpreter.value_if_set(name)
        if found is not None or not IDENTIFIER.fullmatch(name):
            return found
        return None if self.interpreter.is_surely_unset(name) else self.interpreter.unknown()

    def operand(self, name: str) -> Value | None:
        """Return the value of a word in a comparison; None where it is literal."""
        found = self.interpreter.value_if_set(name)
        return self.variable(name) if found is None and FROM_OUTSIDE.fullmatch(name) else found

    def spend(self, cost: int) -> None:
        self.interpreter.spend(cost)

    def holds(self, test: str, name: str) -> Truth:
        match test:
            case "EXISTS" | "IS_DIRECTORY":
                return self.exists(name, folder=test == "IS_DIRECTORY")
            case "COMMAND":
                return True if name.lower() in self.interpreter.functions else None
            case "TARGET":
                return self.is_made(name)
            case "DEFINED":
                return self.defined(name)
            case "IS_ABSOLUTE":
                return name.startswith("/")
            case "POLICY":
                return True if name <= OLDEST_POLICY else None
            case _:
                return None

    def is_made(self, target: str) -> Truth:
        """Return whether a target exists; for a test's target that is known only where tests are built."""
        for_tests = self.interpreter.targets.get(target)
        if for_tests is None or (for_tests and not self.interpreter.frame.testing and self.interpreter.assume != "ON"):
            return None
        return True

    def exists(self, text: str, folder: bool) -> Truth:
        path = self.interpreter.path(text)
        if path is None or text.startswith((BINARY, PREFIX)):
            return None
        files = self.interpreter.files
        if path and not files.is_there(path) and files.absent.is_expected(path):
            return None
        return not path or (files.is_there(path) and not (folder and files.has_file(path)))

    def defined(self, name: str) -> Truth:
        if name.startswith(("ENV{", "CACHE{")):
            return True if name[4:-1] in IS_SET else None
        value = self.variable(name)
        if value is None:
            return False
        return None if not value or any(word.maybe or word.text == UNKNOWN for word in value) else True
