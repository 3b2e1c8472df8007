"""All that PRM008 goes by: what launch files give, and what files of parameters leave out."""

from __future__ import annotations

from dataclasses import dataclass

from .declaring_packages import ParameterContext
from .launch_parameters import LaunchParameters


@dataclass(frozen=True)
class MissingParameters:
    launched: LaunchParameters
    code: ParameterContext
