"""The facts of another package, which note each field that is read."""

from __future__ import annotations

from typing import Any

from ...light_dataclasses import field_names
from ...package.package_facts import PackageFacts

Question = tuple[str, ...]
"""What is asked, and of what: `("field", "src/other", "version")`."""


class RecordedFacts(PackageFacts):
    """The facts of another package: each field that is looked at is noted."""

    __slots__ = ("_noted", "_real")

    def __init__(self, real: PackageFacts, noted: set[Question]) -> None:
        self._real, self._noted = real, noted


def recorded_field(name: str) -> property:
    def get(self: RecordedFacts) -> Any:
        self._noted.add(("field", self._real.folder, name))
        return getattr(self._real, name)

    return property(get)


for _name in field_names(PackageFacts):
    setattr(RecordedFacts, _name, recorded_field(_name))
