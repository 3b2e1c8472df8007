"""Values of the evaluator: each with the span of the expression that made it."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING, Literal

from ....light_dataclasses import dataclass, field
from ....source import Span
from .limits import spend
from .scalar_values import Constant as Constant
from .scalar_values import GlobResult as GlobResult
from .scalar_values import OpenedFile as OpenedFile
from .scalar_values import ScalarValue as ScalarValue
from .scalar_values import Symbol as Symbol
from .scalar_values import Text as Text

if TYPE_CHECKING:
    import ast

Kind = Literal["list", "tuple", "set"]


@dataclass(frozen=True, slots=True)
class Unknown:
    """A value that can't be evaluated."""

    span: Span
    why: str
    """A sentence's part: "`os.environ` depends on the environment"."""
    is_many: bool = False
    """Inside a sequence: any number of unknown items."""
    options: tuple[Value, ...] = ()
    """Possible values, as far as they could be followed."""


@dataclass(slots=True, eq=False)
class Sequence:
    """A list, tuple or set. Lists grow in place, as Python's do: two names may hold the same one."""

    span: Span
    kind: Kind
    items: list[Value] = field(default_factory=list)
    """An `Unknown` with `many` represents any number of unknown items."""
    places: list[Span] = field(default_factory=list)
    """The span of each item: the expression between the commas, or the argument of `append`."""
    is_display: bool = False
    """Whether it was written with brackets at its span."""
    origin: GlobResult | None = None
    """The glob that it is the result of."""
    open_conditions: int = 0
    """How many unknown conditions were open when it was made."""

    @property
    def is_complete(self) -> bool:
        spend(len(self.items) * 4)
        return not any(isinstance(item, Unknown) and item.is_many for item in self.items)

    def add(self, item: Value, place: Span) -> None:
        self.items.append(item)
        self.places.append(place)


@dataclass(slots=True, eq=False)
class Mapping:
    span: Span
    items: dict[Hashable, tuple[Value, Value]] = field(default_factory=dict)
    """By plain key: the key and the value. An `Unknown` with `many` is one that is perhaps not there."""
    rest: list[Unknown] = field(default_factory=list)
    """Why there may be other keys, or other values for these."""
    is_display: bool = False
    open_conditions: int = 0

    @property
    def is_complete(self) -> bool:
        """Whether all keys are known, and are certainly there."""
        return not self.rest and not any(isinstance(i, Unknown) and i.is_many for _, i in self.items.values())

    def get(self, key: Hashable) -> Value | None:
        found = self.items.get(key)
        return None if found is None else found[1]


@dataclass(frozen=True, slots=True)
class PartialText:
    """A text of which some parts are only known as values: `Call`s, `Unknown`s, texts, one after the other."""

    span: Span
    parts: tuple[Value, ...]
    is_path: bool = False


@dataclass(slots=True, eq=False)
class Function:
    """A function or lambda of the file."""

    span: Span
    name: str
    node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
    scope: Namespace
    defaults: dict[str, Value] = field(default_factory=dict)
    is_decorated: bool = False


@dataclass(slots=True, eq=False)
class Class:
    """A class of the file; its scope holds what its body defines."""

    span: Span
    name: str
    scope: Namespace
    bases: tuple[Value, ...] = ()


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument as it was passed; `name` is "" for a positional one."""

    name: str
    value: Value
    span: Span
    """From the keyword's name, or the star, to the end of the value."""


@dataclass(frozen=True, slots=True, eq=False)
class Call:
    """A call of a function that the evaluator does not know."""

    span: Span
    callee: str
    """The full name (`launch_ros.actions.Node`), or the method's alone where `receiver` is given."""
    arguments: tuple[Argument, ...] = ()
    receiver: Value | None = None
    is_certain: bool = True
    """False under an unknown condition or in a loop over unknown items."""
    rest: Unknown | None = None
    """Why there may be other arguments."""

    def get(self, name: str, position: int | None = None) -> Value | None:
        """Return an argument by keyword, or by its place among the positional ones."""
        found = self.argument(name, position)
        return found.value if found else None

    def argument(self, name: str, position: int | None = None) -> Argument | None:
        if position is not None:
            positional = [argument for argument in self.arguments if not argument.name]
            if position < len(positional):
                return positional[position]
        for argument in self.arguments:
            if argument.name == name:
                return argument
        return None

    @property
    def positional(self) -> tuple[Value, ...]:
        return tuple(argument.value for argument in self.arguments if not argument.name)


@dataclass(frozen=True, slots=True, eq=False)
class AttributeValue:
    """An attribute of a value that is only known as a call or another unknown value."""

    span: Span
    of: Value
    name: str


@dataclass(eq=False)
class Namespace:
    """The names of a module, a function or a comprehension."""

    parent: Namespace | None = None
    names: dict[str, Value] = field(default_factory=dict)
    outer: dict[str, Namespace] = field(default_factory=dict)
    """Names declared `global` or `nonlocal`, and where they live."""
    returns: list[Value] = field(default_factory=list)
    """What the function returned so far; more than one where a condition was unknown."""
    yields: Sequence | None = None
    """What the generator yielded so far."""

    def find(self, name: str) -> Value | None:
        at: Namespace | None = self.outer.get(name, self)
        while at is not None:
            if name in at.names:
                return at.names[name]
            at = at.parent
        return None

    def bind(self, name: str, value: Value) -> None:
        self.outer.get(name, self).names[name] = value

    @property
    def top(self) -> Namespace:
        at = self
        while at.parent is not None:
            at = at.parent
        return at


Value = Unknown | ScalarValue | Sequence | Mapping | PartialText | Function | Class | Call | AttributeValue
