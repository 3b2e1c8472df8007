"""Whether anything is lost where a command gets the name of a variable as plain text (CMK126)."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from .needed_places import FOR_HEADERS, FOR_LIBRARIES, NeededPlaces

OF_SOURCE = frozenset({"PROJECT_SOURCE_DIR", "CMAKE_SOURCE_DIR"})
HERE = frozenset({"CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR"})
SHOWN = "the build itself shows where the folder is needed"


@dataclass(frozen=True)
class LostValues:
    cmake: CMake

    def why_not(self, call: EvaluatedCommand, name: str, rest: str) -> str:
        """Return why nothing is lost with a variable and the text behind it, as the end of a sentence; "" else.

        A folder that is not there is passed over: where headers or libraries of it are needed, all that build fail.
        """
        if call.name not in (*FOR_HEADERS, *FOR_LIBRARIES):
            return self.places.why_unread(call)
        home = "" if name in OF_SOURCE else call.folder if name in HERE else None
        if home is None or "$" in rest or "{" in rest:
            return SHOWN
        return self.places.why_not(call, posixpath.normpath(posixpath.join(home, rest.lstrip("/"))))

    @cached_property
    def places(self) -> NeededPlaces:
        return NeededPlaces(self.cmake)
