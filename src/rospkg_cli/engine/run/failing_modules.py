"""Modules of a package whose import fails at another fault, and what imports them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from ...checks.python.installed_modules import InstalledModules
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...languages.python.stopped_places import StoppedPlaces
from ...light_dataclasses import dataclass
from ...source import Span


@dataclass(frozen=True)
class FailingModules:
    installed: InstalledModules
    stops: Callable[[PythonFile], Sequence[Span]]
    """Where a file raises by itself, as findings say."""

    def imports(self) -> Mapping[str, list[Span]]:
        """Return by the path of a file where it imports a module of which the import fails, at whatever distance."""
        files = [file for path in self.installed.names if (file := self.installed.modules.at(path)) is not None]
        failing = {file.path for file in files if fails(file, self.stops(file))}
        found: dict[str, list[Span]] = {}
        while failing:
            for file in files:
                spans = [each.span for each in file.imports if self.is_of(file, each, failing)]
                found |= {file.path: spans} if spans else {}
            more = {file.path for file in files if fails(file, found.get(file.path, ()))} - failing
            if not more:
                break
            failing |= more
        return found

    def is_of(self, file: PythonFile, each: Import, failing: set[str]) -> bool:
        """Return whether an import runs one of some modules, which is not the file itself."""
        if each.is_optional or each.is_for_typing:
            return False
        return any(path in failing and path != file.path for path in self.run_by(file, each))

    def run_by(self, file: PythonFile, each: Import) -> Iterator[str]:
        """Yield the files that an import runs: of the packages around the module, too."""
        module = self.installed.absolute(each, file.path)
        parts = module.split(".")
        around = [".".join(parts[:end]) for end in range(1, len(parts) + 1)]
        for name in (*around, *(f"{module}.{name}" for name in each.names)):
            yield self.installed.sources.get(name, "")


def fails(file: PythonFile, stops: Sequence[Span]) -> bool:
    """Return whether the import of a file always ends at one of some places."""
    return bool(stops) and StoppedPlaces(file, tuple(sorted(stops)), lambda _: True).ends_module
