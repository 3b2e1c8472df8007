"""A condition of code on a parameter, an option or a variable."""

from __future__ import annotations

from ...light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Switch:
    """A condition that does not hold unless something sets a parameter or variable."""

    variable: str
    parameters: tuple[str, ...]
    """Those that the variable is given; none for a constant."""
    is_on: bool
    """The state that the condition asks for."""
    kind: str = "parameter"
    """What the names are of: a parameter, an option of a command, or a variable of the environment."""
