"""Which variables nothing in a package's CMake can set."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .foreign_commands import foreign_commands

ANY_REFERENCE = regex(r"\$(?:ENV|CACHE)?\{[^{}]*\}")
WHOLE_REFERENCE = regex(r"\$\{([A-Za-z_]\w*)\}")
NO_WORD = regex(r"\W")
NAME = regex(r"[A-Za-z_]\w*")


@dataclass(frozen=True)
class SetVariables:
    cmake: CMake

    def may_be_set(self, name: str) -> bool:
        """Return whether a file of the package names a variable outside of `${…}`, where a command may set it."""
        return self.cmake.reads_unknown_files or name in self.mentioned or name.startswith(self.prefixes)

    def is_own(self, name: str) -> bool:
        """Return whether a name is like none that CMake, a package that is found, or a macro of one sets."""
        first = name.lower()
        theirs = ("cmake_", "ament_", "catkin_", "project_", self.cmake.project_name.lower() or "cmake_")
        found = tuple(NO_WORD.sub("_", each.name.lower()) for each in self.cmake.packages)
        return not first.startswith(theirs + found) and next(foreign_commands(self.cmake), None) is None

    @cached_property
    def mentioned(self) -> frozenset[str]:
        """All names in arguments outside of `${…}`: a command may set a variable of that name."""
        commands = (command for file in self.cmake.files for command in file.syntax.commands)
        texts = (argument.text for command in commands for argument in command.arguments)
        return frozenset(name for text in texts for name in NAME.findall(ANY_REFERENCE.sub(" ", text)))

    @cached_property
    def prefixes(self) -> tuple[str, ...]:
        """What the variables begin with that `cmake_parse_arguments` sets."""
        calls = self.cmake.named("cmake_parse_arguments")
        return tuple(f"{text}_" for call in calls for text in call.texts if NAME.fullmatch(text))

    def empty_variable(self, word: Word) -> str | None:
        """Return the name of the variable that is all of a word, where nothing sets it: targets are the package's own,
        so that no other one sets a variable for them."""
        if word.text != UNKNOWN or self.cmake.reads_unknown_files:
            return None
        found = WHOLE_REFERENCE.fullmatch(self.cmake.source_text(word))
        name = found[1] if found is not None else ""
        return name if name and not self.may_be_set(name) and self.is_own(name) else None
