"""Parameters that a package's code declares: what files of parameters are compared with."""

from __future__ import annotations

from collections.abc import Iterable

from ...light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class DeclaredParameter:
    """One declaration, or one read, of a parameter."""

    name: str
    """As rcl names it, with dots; where `tail`, what follows a part that is only known at run time."""
    tail: bool
    type: str
    """bool, int, double or string, with `[]` for a list of them; "" where it is unknown."""
    required: bool
    """Declared without a default value: the node stops where none is set."""
    path: str
    """The file that declares it."""
    default: str = ""
    """The default value, where it is written as a number, a truth value or a text; "" where it is not."""

    def fits(self, name: str) -> bool:
        """Return whether a parameter of this name is this one."""
        if not self.tail:
            return name == self.name
        return name.endswith(self.name if self.name.startswith(".") else f".{self.name}") or name == self.name


NONE = ""


def type_named(declared: Iterable[DeclaredParameter], name: str) -> str:
    """Return the one type that all declarations of a name have; "" where they differ, or one is unknown."""
    types = {each.type for each in declared if each.fits(name)}
    return types.pop() if len(types) == 1 else NONE


@dataclass(frozen=True, slots=True)
class NodeName:
    """An executable or a component (its class), and the one name that its code gives nodes."""

    starts: str
    name: str


@dataclass(frozen=True, slots=True)
class NodeCode:
    """An executable or a component (its class), and the files whose code certainly runs in it."""

    starts: str
    paths: frozenset[str]
