"""One of the things that `rospkg doctor` examines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...light_dataclasses import dataclass, field


@dataclass(frozen=True)
class Topic:
    name: str
    """As it is shown."""
    lines: tuple[str, ...]
    """What was found, in words."""
    data: Mapping[str, Any] = field(default_factory=dict)
    """The same as JSON values."""
    advice: str = ""
    """What to do where it could be better; "" where nothing is to be done."""
    is_wrong: bool = False
    """Whether lint can't run as it should."""

    @property
    def key(self) -> str:
        """Its key in JSON."""
        return self.name.lower().replace(" ", "_")

    def document(self) -> dict[str, Any]:
        """Return the topic as an object of JSON."""
        wrong = {"problem": self.lines[0]} if self.is_wrong else {}
        return {**self.data, **wrong, **({"advice": self.advice} if self.advice else {})}
