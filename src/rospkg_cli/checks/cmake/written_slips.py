"""Values of CMake that are a letter off: `flase`, which it takes for true, and a folder without its slash."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandArgument
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.referenced_paths import ReferencedPaths
from ...source import Span
from ...suggest import is_slip
from .needed_places import NeededPlaces

JOINED = regex(r"\$\{((?:CMAKE|PROJECT|CMAKE_CURRENT)_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR)\}([A-Za-z_][\w./-]*)")
VALUE_AT = {"set": 1, "option": 2}
"""Commands that give a variable one value, and where it stands."""


@dataclass(frozen=True)
class WrittenSlip:
    call: EvaluatedCommand
    span: Span
    message: str
    why_harmless: str = ""
    """Why nothing is lost; "" where something is."""


@dataclass(frozen=True)
class WrittenSlips:
    cmake: CMake

    def all(self) -> Iterator[WrittenSlip]:
        """Yield each place once."""
        judged = {each.word.span.start for each in ReferencedPaths(self.cmake).missing()}
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if place in seen:
                continue
            seen.add(place)
            yield from self.booleans(call)
            for argument in call.command.arguments:
                if argument.kind != "bracket" and argument.span.start not in judged:
                    yield from self.joined(call, argument)

    def booleans(self, call: EvaluatedCommand) -> Iterator[WrittenSlip]:
        """Yield the value of a variable that a condition asks for by its name alone: any word but the false ones is
        true."""
        at, given = VALUE_AT.get(call.name, 0), call.command.arguments
        if not at or len(given) <= at or (call.name == "set" and len(given) > 2 and given[2].text != "CACHE"):
            return
        name, value = given[0].text, given[at]
        if is_slip(value.text.lower(), "false") and self.is_asked_for(name):
            message = f"`{value.text}` is none of the words that CMake takes for false: `if({name})` is true"
            yield WrittenSlip(call, value.span, f"{message}; write `FALSE`")

    def is_asked_for(self, name: str) -> bool:
        condition = re.compile(rf"\b(?:if|elseif|while)\s*\([^)]*(?<![{{\w]){re.escape(name)}(?![\w}}])", re.IGNORECASE)
        return any(condition.search(file.source.text) for file in self.cmake.files)

    def joined(self, call: EvaluatedCommand, argument: CommandArgument) -> Iterator[WrittenSlip]:
        """Yield a folder and a path that make one name, where the path is in the folder."""
        files = self.cmake.package_files
        match = JOINED.match(argument.text)
        if match is None:
            return
        variable, rest = match.groups()
        folder = "" if "CURRENT" not in variable else call.folder
        folder = posixpath.dirname(call.path) if "LIST" in variable else folder
        is_path = files.is_there(posixpath.normpath(posixpath.join(folder, rest)))
        if is_path and not (folder and files.is_there(folder + rest)):
            lost = f"`${{{variable}}}` ends without a slash: `{argument.text}` is no path"
            why = self.places.why_not(call, posixpath.normpath(posixpath.join(folder, rest)))
            todo = f"write `${{{variable}}}/{rest}`{'; ' if why else ''}{why}"
            yield WrittenSlip(call, argument.span, f"{lost}; {todo}", why)

    @cached_property
    def places(self) -> NeededPlaces:
        return NeededPlaces(self.cmake)
