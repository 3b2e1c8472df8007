"""CMake files after they were evaluated: their commands as CMake would run them, in order."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import CMakeFile
from ...languages.cmake.syntax import CommandInvocation
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass, field


@dataclass(frozen=True)
class EvaluatedFiles:
    """The commands of the CMake files of a package."""

    package_files: PackageFiles = field(repr=False)
    files: tuple[CMakeFile, ...]
    calls: tuple[EvaluatedCommand, ...]
    unreachable: tuple[EvaluatedCommand, ...] = ()
    """Commands in branches that are never taken and loops over nothing."""
    stopped: str = ""
    """Why the evaluation stopped early: then nothing may be concluded from what is missing."""
    reads_unknown_files: bool = False
    """Whether it includes files that can't be read: they may add any target."""
    includes_unknown_files: bool = False
    """Whether not all of these are folders that are not there, as of submodules."""
    own_name: str = ""
    """The package's name, which a macro may read out of package.xml for project()."""

    @property
    def is_complete(self) -> bool:
        return not self.stopped

    @property
    def root(self) -> CMakeFile:
        return self.files[0]

    def file(self, path: str) -> CMakeFile:
        """Return the file with a path; raises KeyError."""
        return self._files[path]

    @cached_property
    def _files(self) -> dict[str, CMakeFile]:
        return {file.path: file for file in self.files}

    def last_index(self, command: CommandInvocation) -> int:
        """Return the index of the last call of a command, -1 where it is never run."""
        return self._places.get(id(command), -1)

    @cached_property
    def _places(self) -> dict[int, int]:
        return {id(call.command): place for place, call in enumerate(self.calls)}

    @cached_property
    def functions(self) -> frozenset[str]:
        """The names of the package's own functions and macros."""
        commands = (command for file in self.files for command in file.syntax.commands)
        defined = [command for command in commands if command.name in ("function", "macro") and command.arguments]
        return frozenset(command.arguments[0].text.lower() for command in defined)

    def source_text(self, word: Word) -> str:
        """Return the source text of a word: `${LIBRARY}`, `"a b"`."""
        return self.file(word.path).source.slice(word.span)

    def quoted(self, word: Word) -> str:
        """Return a word for a message, with its source text where that differs."""
        raw = self.source_text(word).strip('"')
        return f"`{word.text}`" if raw == word.text or not raw else f"`{word.text}` (`{raw}`)"

    @cached_property
    def _by_name(self) -> dict[str, list[EvaluatedCommand]]:
        found: dict[str, list[EvaluatedCommand]] = {}
        for call in self.calls:
            found.setdefault(call.name, []).append(call)
        return found

    def named(self, *names: str) -> list[EvaluatedCommand]:
        """Return the calls of the commands with these names, in order."""
        there = [name for name in names if name in self._by_name]
        if len(there) <= 1:
            return self._by_name[there[0]] if there else []
        return [call for call in self.calls if call.name in there]
