"""Rule input: modules that only functions which no program calls import."""

from __future__ import annotations

from ..languages.python.file import PythonFile
from ..languages.python.imports import Import
from ..light_dataclasses import dataclass
from .reached_definitions import ReachedDefinitions
from .reached_modules import ReachedModules


@dataclass(frozen=True)
class UnwantedModules:
    reached: ReachedModules
    definitions: ReachedDefinitions

    def has(self, file: PythonFile) -> bool:
        """Return whether only functions that no program leads to import a module."""
        uses = self.uses(file)
        idle = (each.is_local and not self.definitions.leads_to(other, each.span) for other, each in uses)
        return bool(uses) and all(idle) and not self.reached.is_wanted(file.path)

    def uses(self, file: PythonFile) -> list[tuple[PythonFile, Import]]:
        """Return the imports of a module, with the files that have them."""
        return self.reached.imports.uses.get(self.reached.installed.names.get(file.path, ""), [])
