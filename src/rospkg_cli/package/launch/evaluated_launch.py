"""What the evaluation of a Python launch file leaves: the calls that it makes, and what its functions return."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from ...languages.python.evaluate.values import Call, Function, Namespace, Value
from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...source import Span

UseKind = Literal["function", "method", "operator", "lookup", "refused"]
"""Refused is what Python raises TypeError for: a path that is joined of a tuple."""


@dataclass(frozen=True, slots=True)
class SubstitutionUse:
    """A place where Python itself works on substitutions or conditions, whose values only the launch knows."""

    span: Span
    """Of the whole expression."""
    kind: UseKind
    name: str
    """Of the function with its module (`os.path.join`), or of the method; the operator: `+`, `==`, `!=`, `not`, `and`,
    `or`, and `f""` for an f-string."""
    operands: tuple[Value, ...]
    """Of a function the substitution that is passed to it, of a method the object, of a lookup in a dict the key.
    Of what is refused the values that are no text."""


@dataclass(frozen=True)
class EvaluatedLaunch:
    file: PythonFile
    scope: Namespace
    """The names of the module."""
    calls: tuple[Call, ...] = ()
    """Every call that was evaluated and not followed: of launch, of the standard library. Each once."""
    returned: Mapping[int, tuple[Function, Value]] | None = None
    """What each function that launch calls returns, by the `id` of its node."""
    uses: tuple[SubstitutionUse, ...] = ()
    deferred: tuple[Span, ...] = ()
    """Functions that launch calls only when it visits their action, or that nothing calls."""

    def result_of(self, function: Function) -> Value | None:
        """Return what a function that launch calls returns; None where nothing called it."""
        found = (self.returned or {}).get(id(function.node))
        return found[1] if found else None
