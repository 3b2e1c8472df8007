"""An argument of CMake where the name of a package belongs, and that is none (CMK117)."""

from __future__ import annotations

from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass

EXPORTED, HANDED = "ament_export_dependencies", "ament_target_dependencies"


@dataclass(frozen=True)
class MistypedPackage:
    word: Word
    call: EvaluatedCommand
    kind: Literal["misspelt", "target", "variable", "own", "nowhere", "keyword", "imported", "case"]
    near: str = ""
    """The package that is certainly intended, of one that is misspelt."""
    variable: str = ""
    """The variable that stands where packages belong, as it is written."""
    is_certain: bool = True
    """Whether what the package itself says shows that there is none of this name, whatever is installed."""

    @property
    def is_guess(self) -> bool:
        """Whether only the similar name of another package shows that the one looked for does not exist."""
        return self.kind == "misspelt" and self.call.name != HANDED
