"""Where the build itself puts programs and libraries, and whether an install folder is that place or a copy of it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import BINARY, PREFIX, UNKNOWN
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .cmake_project import CMake

OUTPUT = regex(r"(?:CMAKE_)?(?:RUNTIME|LIBRARY)_OUTPUT_DIRECTORY(?:_[A-Z]+)?|(?:EXECUTABLE|LIBRARY)_OUTPUT_PATH")
SETTERS = ("set", "set_target_properties", "set_property")


@dataclass(frozen=True)
class OutputFolders:
    cmake: CMake

    def install(self, target: str) -> bool:
        """Return whether what is built of a target lands in the install folder without a rule of its own."""
        return any(call.name == "set" or target in call.texts for call in self.placing)

    @cached_property
    def placing(self) -> tuple[EvaluatedCommand, ...]:
        """The commands that have the build put its files there, or into a folder that is installed as a whole."""
        calls = self.cmake.named(*SETTERS)
        return tuple(call for call in calls if any(map(self.is_installed, folders_in(call))))

    def is_installed(self, folder: str) -> bool:
        if folder.startswith(PREFIX) or UNKNOWN in folder:
            return True
        return any(f"{folder}/".startswith(f"{each}/") for each in self.copied)

    @cached_property
    def copied(self) -> tuple[str, ...]:
        """The folders of the build that rules install."""
        words = (word.text for rule in self.cmake.installs if rule.kind == "DIRECTORY" for word in rule.items)
        return tuple(text.rstrip("/") for text in words if text.startswith(BINARY))


def folders_in(call: EvaluatedCommand) -> Iterator[str]:
    return (after.rstrip("/") for before, after in pairwise(call.texts) if OUTPUT.fullmatch(before))
