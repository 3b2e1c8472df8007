"""Rule input: when the places of a package's Python code run: at every start, in some runs, or never."""

from __future__ import annotations

import ast

from ..languages.python.branches import is_under_condition
from ..languages.python.certain_nodes import is_guard
from ..languages.python.file import PythonFile
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..source import Span
from .certain_places import CertainPlaces
from .interfaces.seldom_run import is_in_handler
from .interfaces.uncalled_methods import UncalledMethods
from .off_places import OffPlaces
from .python.idle_functions import IdleFunctions
from .python.installed_modules import InstalledModules
from .python.late_places import LatePlaces
from .python.run_imports import RunImports
from .reached_definitions import ReachedDefinitions
from .reached_modules import ReachedModules
from .repository.path_starts import is_started_by_path
from .shown.units import is_in_function
from .shown.ways import ShownWays
from .unimported_modules import UnimportedModules
from .unwanted_modules import UnwantedModules
from .why_seldom import AT_TIMES, IN_TEST, MILDER, UNIMPORTED, UNWANTED, WHY, Met


@dataclass(frozen=True)
class ReachedPlaces:
    run: RunImports
    table: InstallTable
    installed: InstalledModules
    reached: ReachedModules
    uncalled: UncalledMethods
    definitions: ReachedDefinitions
    shown: ShownWays
    unimported: UnimportedModules
    unwanted: UnwantedModules
    late: LatePlaces
    idle: IdleFunctions
    certain: CertainPlaces
    off: OffPlaces | None = None

    def met(self, file: PythonFile, span: Span) -> Met:
        """Return when a place runs that does not run at every start, as far as the code of the package shows."""
        return "never" if self.idle.has(file, span) else self.as_shown(file, span)

    def as_shown(self, file: PythonFile, span: Span) -> Met:
        """Return when a place runs; "maybe" only where the code shows a way to it with one condition at most."""
        met = self.met_by_anybody(file, span)
        if met != "maybe":
            return met
        conditions = self.conditions(file, span)
        if conditions is None or conditions > 1:
            return "unshown" if conditions is None else "seldom"
        return "unspun" if self.shown.is_unspun(file, span) else "maybe"

    def conditions(self, file: PythonFile, span: Span) -> int | None:
        """Return how many conditions are on the shortest known way to a place; None where no way is known.

        The users of a library count as importing its modules, but for those that nothing in the workspace imports.
        """
        found = self.shown.conditions(file, span)
        if found is None and not is_in_function(file, span) and self.reached.is_library:
            is_started = self.installed.names.get(file.path) in self.reached.started
            is_met = is_started and not self.unimported.has(file.path)
            return self.shown.conditions_in_module(file, span) if is_met else None
        return found

    def met_by_anybody(self, file: PythonFile, span: Span) -> Met:
        """Return when a place runs; what a package without programs offers may be called by others."""
        if self.is_idle(file, span):
            return "never"
        if self.is_late(file, span):
            return "late"
        if self.is_ended(file, span):
            return "ended"
        is_seldom = is_in_handler(file, span) or self.definitions.is_turned_off(file, span)
        return "branch" if is_seldom or self.is_by_path(file, span) or self.is_off(file, span) else "maybe"

    def is_off(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place runs only with a parameter or option that is off by default, and that nothing sets."""
        return self.off is not None and self.off.has(file, span)

    def is_late(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place runs only behind a `spin`, which Ctrl-C leaves by an exception."""
        return self.late.has(file, span)

    def is_ended(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place runs only after the loop in a constructor in which the program does its work."""
        from .behind_loops import is_behind_loop  # few packages need it, and importing it takes time

        return is_behind_loop(self.shown.meanings, file, span)

    def why_seldom(self, path: str, span: Span) -> str:
        """Return the end of a message that says why a place seldom or never runs; "" for one that does."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        if file is None:
            return ""
        if self.unwanted.has(file):
            return UNWANTED
        if self.unimported.has(path):
            return UNIMPORTED
        is_inner = is_in_function(file, span) or role_of(path) == "test" or self.is_aside(file)
        met = self.as_shown(file, span) if is_inner else self.met_by_anybody(file, span)
        met = self.met_by_importers(file) if met == "maybe" and not is_inner else met
        return WHY.get(met, "")

    def is_aside(self, file: PythonFile) -> bool:
        """Return whether a file is a module of a package with programs that no code imports, and no page starts."""
        if not self.table.knows("executable") or self.reached.is_library or self.reached.has(file.path):
            return False
        return not is_started_by_path(self.installed.files, file.path)

    def why_milder(self, path: str, span: Span) -> str:
        """Return why a place runs only at times: in a test, or under a condition on the way to it; "" for others."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        if file is None:
            return ""
        is_offered = self.reached.is_library and not is_in_function(file, span)
        if role_of(path) == "test" or (not is_offered and self.shown.is_for_tests(file, span)):
            return IN_TEST
        return AT_TIMES if self.conditions(file, span) else ""

    def met_by_importers(self, file: PythonFile) -> Met:
        """Return when a module is imported that only functions import, as an optional part of a library."""
        uses = self.unwanted.uses(file)
        if not uses or self.reached.is_wanted(file.path) or not all(each.is_local for _, each in uses):
            return "maybe"
        found = {self.as_shown(other, each.span) for other, each in uses}
        return "maybe" if "maybe" in found else min(found, key=MILDER.index)

    def is_conditional(self, path: str, span: Span) -> bool:
        """Return whether a place is in a branch of its function, or in a module that others import under `try`."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        return file is not None and (is_under_condition(file, span) or self.reached.is_optional(path))

    def is_idle(self, file: PythonFile, span: Span) -> bool:
        """Return whether no program of the package leads to a place."""
        is_left = self.reached.is_left(file.path) or self.uncalled.has(file.path, span)
        return is_left or not self.definitions.leads_to(file, span) or self.unwanted.has(file)

    def is_by_path(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is under `if __name__ == '__main__'` of a module that an entry point starts."""
        guards = [each for each in file.tree.body if isinstance(each, ast.If) and is_guard(each)]
        is_under = any(file.span(part).holds(span) for each in guards for part in each.body)
        rows = self.table.of("executable") if is_under else ()
        is_program = any(row.source == file.path and not row.entry for row in rows)
        return is_under and not is_program and self.installed.names.get(file.path) in self.reached.entries
