"""All that PRM008 goes by: what launch files give, and what files of parameters leave out."""

from __future__ import annotations

from dataclasses import dataclass

from .launched import LaunchedParameters
from .owners import PackageParameters


@dataclass(frozen=True)
class MissingParameters:
    launched: LaunchedParameters
    code: PackageParameters
