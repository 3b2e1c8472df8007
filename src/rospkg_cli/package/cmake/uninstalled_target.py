"""A target that is built and not installed, and what does not work without it."""

from __future__ import annotations

from typing import Literal, NamedTuple

from ...languages.cmake.targets import Target
from ...light_dataclasses import dataclass

User = Literal["component", "exporter", "linked target", "exported target", "parameter library"]


class TargetUse(NamedTuple):
    """What does not work without a target; `name` is that of a component or of another target."""

    user: User
    name: str = ""


@dataclass(frozen=True)
class UninstalledTarget:
    target: Target
    needed_by: TargetUse | None
    """None for an executable."""
    stops: bool = False
    """Whether CMake itself stops."""
