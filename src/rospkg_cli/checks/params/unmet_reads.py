"""Places of code that nothing of the package leads to: what is wrong there stops no node."""

from __future__ import annotations

from ...languages.cpp.file import CppFile
from ...languages.cpp.unconditional import unconditional
from ...languages.python.branches import is_under_condition
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...source import Span
from ..cpp.uncalled_members import is_in_uncalled
from ..depends.sources_by_use import sources_by_use
from ..interfaces.uncalled_methods import UncalledMethods
from ..left_files import LeftFiles
from ..off_places import OffPlaces
from ..reached_definitions import ReachedDefinitions


@dataclass(frozen=True)
class UnmetReads:
    left: LeftFiles | None
    uncalled: UncalledMethods | None
    definitions: ReachedDefinitions | None
    cmake: CMake | None
    off: OffPlaces | None = None

    def in_python(self, path: str, place: Span) -> bool:
        """Return whether nothing imports or starts a module, or calls the function around a place."""
        if (self.left is not None and self.left.has(path)) or (self.uncalled and self.uncalled.has(path, place)):
            return True
        reached = self.definitions
        file = reached.run.modules.at(path) if reached is not None else None
        if reached is None or file is None:
            return False
        is_off = reached.is_turned_off(file, place) or (self.off is not None and self.off.has(file, place))
        return is_off or not reached.leads_to(file, place)

    def in_cpp(self, path: str, place: Span, files: tuple[CppFile, ...]) -> bool:
        """Return whether a C++ file is not compiled or included, or nothing calls the function around a place."""
        if self.cmake is not None:
            known, _ = sources_by_use(self.cmake, files)
            if known.is_known and path not in known.run | known.tests:
                return True
        return any(is_in_uncalled(each, place, files) for each in files if each.path == path)

    def is_seldom(self, path: str, place: Span, files: tuple[CppFile, ...]) -> bool:
        """Return whether a function reaches a place only under a condition, or only others may include a header."""
        if path.endswith(".py"):
            file = self.definitions.run.modules.at(path) if self.definitions is not None else None
            return file is not None and is_under_condition(file, place)
        known = sources_by_use(self.cmake, files)[0] if self.cmake is not None else None
        if known is not None and known.is_known and path not in known.own:
            return True
        return not any(unconditional(each.source.text, [place.start]) for each in files if each.path == path)
