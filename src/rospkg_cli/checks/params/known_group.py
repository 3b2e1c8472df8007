"""The values that one node, controller or plugin of a well-known package gets, and what that package declares."""

from __future__ import annotations

from functools import cached_property
from typing import Literal

from ...light_dataclasses import dataclass
from ...package.params.parameter_file import ParameterFile
from ...ros.known_nodes import KnownParameter, known_parameters, removed_parameters
from .given_values import GivenValue
from .idle_nodes import Start

PartKind = Literal["node", "controller", "plugin"]


@dataclass(frozen=True)
class KnownGroup:
    """Values that one node, controller or plugin gets."""

    path: str
    kind: PartKind
    packages: tuple[str, ...]
    """Well-known packages, each of which may be the one that has the node."""
    values: tuple[GivenValue, ...]
    file: ParameterFile | None = None
    """The file that gives them; None for a launch file."""
    is_certain: bool = True
    """Whether the node is certainly of one of the packages, and started: not by its name alone, nor a plugin that no
    list of its block names.
    """
    start: Start | None = None
    """Where a launch file starts the node; None for a file."""

    @cached_property
    def declared(self) -> tuple[KnownParameter, ...]:
        return tuple(each for package in self.packages for each in known_parameters(package))

    @cached_property
    def removed(self) -> tuple[KnownParameter, ...]:
        return tuple(each for package in self.packages for each in removed_parameters(package))

    def is_declared_by(self, package: str, name: str) -> bool:
        return any(each.fits(name) for each in known_parameters(package))

    def wanted_type(self, name: str) -> str:
        """Return the type that all declarations of a name have; "" where there is none."""
        types = {each.type for each in self.declared if each.fits(name)}
        return types.pop() if len(types) == 1 else ""
