"""A place in a robot, an RViz config or a parameter file that needs another package."""

from __future__ import annotations

from ...light_dataclasses import dataclass, replace
from ...source import Span

UNOPENED = "; nothing here opens this file"


@dataclass(frozen=True, slots=True)
class RobotUse:
    """A place outside of code that uses a file or a plugin of another package."""

    path: str
    span: Span
    usage: str
    """What is used there, as the rest of a sentence: `and its files are used here`."""
    consequence: str
    """What happens where the package is not installed."""
    is_optional: bool = False
    """Whether the package may not be needed at all."""
    why: str = ""
    """Why no run of the package reaches the place, as the end of a message."""


def unopened(use: RobotUse) -> RobotUse:
    """Return a use in a file that nothing opens: an optional one."""
    return replace(use, is_optional=True, why=UNOPENED)
