"""Targets that can't both be added, because they have the same name."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake


@dataclass(frozen=True)
class DuplicateTarget:
    first: Word
    second: Word
    first_command: str
    second_command: str

    @property
    def name(self) -> str:
        return self.second.text


def duplicate_targets(cmake: CMake) -> Iterator[DuplicateTarget]:
    """Yield each target that is added twice, at the second position."""
    first: dict[str, tuple[Word, str]] = {}
    for target in cmake.targets:
        if not is_sure(target):
            continue
        name, command = target.name, target.call.name
        if name in first:
            yield DuplicateTarget(first[name][0], target.word, first[name][1], command)
        else:
            first[name] = (target.word, command)
    yield from duplicate_python_packages(cmake)


def is_sure(target: Target) -> bool:
    imported = target.options & {"IMPORTED"}
    return UNKNOWN not in target.name and not target.word.maybe and not target.call.maybe and not imported


def duplicate_python_packages(cmake: CMake) -> Iterator[DuplicateTarget]:
    """rosidl installs a Python package of the project's name, in the same way as ament_python_install_package."""
    generated = [each for each in cmake.interface_targets if not each.call.maybe and not each.skip_install]
    for call in cmake.named("ament_python_install_package"):
        for word in call.words[:1]:
            if generated and word.text == cmake.project_name and not call.maybe:
                yield DuplicateTarget(generated[0].target, word, generated[0].call.name, call.name)
