"""Targets that a command names before another one makes them: CMake reads from top to bottom, and stops there."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from .named_targets import TargetReference, target_references
from .target_references import TargetReferences


@dataclass(frozen=True)
class EarlyReference:
    reference: TargetReference
    maker: str
    """The command that makes the target, further down."""


@dataclass(frozen=True)
class EarlyReferences:
    cmake: CMake

    def all(self) -> Iterator[EarlyReference]:
        """Yield the first command of each target that stands above what makes it; none that may have been made."""
        references = TargetReferences(self.cmake)
        if not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return
        places = {id(call): place for place, call in enumerate(self.cmake.calls)}
        made: dict[str, int] = {}
        for target in self.cmake.targets:
            made.setdefault(target.name, places.get(id(target.call), -1))
        foreign = {text for call in references.foreign for text in call.texts if call.name not in OF_TARGETS}
        seen: set[str] = set()
        for each in target_references(self.cmake):
            name, place = each.word.text, places.get(id(each.call), -1)
            is_certain = each.kind == "target" and each.word.is_known and not (each.word.maybe or each.call.maybe)
            if is_certain and 0 <= place < made.get(name, -1) and name not in foreign | seen:
                seen.add(name)
                yield EarlyReference(each, self.cmake.calls[made[name]].name)


OF_TARGETS = frozenset({"ament_target_dependencies", "rosidl_target_interfaces"})
"""Commands that no table of CMake's has and that make no target."""
