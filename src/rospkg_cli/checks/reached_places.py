"""Rule input: when the places of a package's Python code are come to: at every start, in some runs, or by nobody."""

from __future__ import annotations

import ast
from functools import cached_property
from typing import Literal

from ..languages.python.branches import is_under_condition
from ..languages.python.certain_nodes import certain_nodes, is_guard
from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of_kind
from ..languages.python.stopped_places import StoppedPlaces
from ..languages.python.unreached_functions import unreached_functions
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..source import Span
from .interfaces.seldom_run import is_in_handler
from .interfaces.uncalled_methods import UncalledMethods
from .off_places import OffPlaces
from .python.behind_spin import called_behind_spin, is_behind_spin, is_called_late
from .python.installed_modules import InstalledModules
from .python.run_imports import RunImports
from .reached_definitions import ReachedDefinitions
from .reached_modules import ReachedModules
from .repository.path_starts import is_started_by_path
from .shown.units import is_in_function
from .shown.ways import ShownWays
from .unimported_modules import UnimportedModules

Met = Literal["maybe", "branch", "late", "ended", "unspun", "seldom", "unshown", "never"]
"""In some runs; after another failure, by a switch or by the file's path alone; behind a `spin` that Ctrl-C leaves;
behind the loop of a constructor; in a callback of a node that nothing spins; under several conditions at once; where
nothing is shown to come; where nothing leads."""

WHY: dict[Met, str] = {
    "branch": "; it runs only where its condition holds",
    "late": "; it stands behind `spin`, which Ctrl-C leaves by an exception of its own",
    "ended": "; it runs only once the loop has ended in which the program stays",
    "unspun": "; it is in a callback, and nothing spins the node",
    "seldom": "; it runs only where several conditions hold at once",
    "unshown": "; nothing here shows that a program comes to this line",
    "never": "; nothing here leads to this function",
}
"""What is said of a place that seldom or never runs."""
MILDER: tuple[Met, ...] = ("branch", "seldom", "late", "ended", "unspun", "unshown", "never")
UNWANTED = "; nothing here leads to what imports this module"
IN_TEST = "; only a test runs it"
AT_TIMES = "; a condition stands on the way to it"
UNIMPORTED = "; nothing here imports this module"


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
    off: OffPlaces | None = None

    def met(self, file: PythonFile, span: Span) -> Met:
        """Return when a place is come to that is not met at every start, as far as the package itself shows."""
        return "never" if self.is_in_idle_function(file, span) else self.as_shown(file, span)

    def as_shown(self, file: PythonFile, span: Span) -> Met:
        """Return when a place is come to, "maybe" only where a way is shown on which one condition stands at most."""
        met = self.met_by_anybody(file, span)
        if met != "maybe":
            return met
        conditions = self.conditions(file, span)
        if conditions is None or conditions > 1:
            return "unshown" if conditions is None else "seldom"
        return "unspun" if self.shown.is_unspun(file, span) else "maybe"

    def conditions(self, file: PythonFile, span: Span) -> int | None:
        """Return how many conditions stand on the shortest way that is shown to a place; None where none is shown.

        Whoever uses a library imports its modules, but for those that nothing here does.
        """
        found = self.shown.conditions(file, span)
        if found is None and not is_in_function(file, span) and self.reached.is_library:
            is_started = self.installed.names.get(file.path) in self.reached.started
            is_met = is_started and not self.unimported.has(file.path)
            return self.shown.conditions_in_module(file, span) if is_met else None
        return found

    def met_by_anybody(self, file: PythonFile, span: Span) -> Met:
        """Return when a place is come to; what a package without programs offers may be called by others."""
        if self.is_idle(file, span):
            return "never"
        if self.is_late(file, span):
            return "late"
        if self.is_ended(file, span):
            return "ended"
        is_seldom = is_in_handler(file, span) or self.definitions.is_turned_off(file, span)
        return "branch" if is_seldom or self.is_by_path(file, span) or self.is_off(file, span) else "maybe"

    def is_off(self, file: PythonFile, span: Span) -> bool:
        """Return whether a parameter or an option which is off by default, and which nothing sets, leads to a place."""
        return self.off is not None and self.off.has(file, span)

    def is_late(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is led to behind a `spin` alone that Ctrl-C leaves by an exception."""
        if is_behind_spin(file, span) or is_called_late((each for _, each in self.run.files), file, span):
            return True
        if file.path not in self.behind_spins:
            self.behind_spins[file.path] = called_behind_spin(file, lambda name: self.is_taken(file, name))
        places = self.behind_spins[file.path]
        return places is not None and places.has(span.start)

    def is_ended(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is led to once a constructor has left the loop that is its program's work."""
        from .behind_loops import is_behind_loop  # what few packages need, and each start would pay for

        return is_behind_loop(self.shown.meanings, file, span)

    @cached_property
    def behind_spins(self) -> dict[str, StoppedPlaces | None]:
        return {}

    def is_taken(self, file: PythonFile, name: str) -> bool:
        """Return whether another file imports a name, or reads it of something."""
        return not self.taken.get(name, frozenset()) <= {file.path}

    @cached_property
    def taken(self) -> dict[str, set[str]]:
        """By each name that files import or read of something, the paths of these files."""
        found: dict[str, set[str]] = {}
        for _, file in self.run.files:
            names = {name for each in file.imports for name in each.names}
            for name in names.union(each.attr for each in nodes_of_kind(file.tree, ast.Attribute)):
                found.setdefault(name, set()).add(file.path)
        return found

    def why_seldom(self, path: str, span: Span) -> str:
        """Return what is said of a place that seldom or never runs, beside what is said of its whole module."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        if file is None:
            return ""
        if self.is_unwanted(file):
            return UNWANTED
        if self.unimported.has(path):
            return UNIMPORTED
        is_inner = is_in_function(file, span) or role_of(path) == "test" or self.is_aside(file)
        met = self.as_shown(file, span) if is_inner else self.met_by_anybody(file, span)
        met = self.met_by_importers(file) if met == "maybe" and not is_inner else met
        return WHY.get(met, "")

    def is_aside(self, file: PythonFile) -> bool:
        """Return whether a file is a module beside known programs that no code imports, and that pages only name."""
        if not self.table.knows("executable") or self.reached.is_library or self.reached.has(file.path):
            return False
        return not is_started_by_path(self.installed.files, file.path)

    def why_milder(self, path: str, span: Span) -> str:
        """Return why a place is met by some alone: by a test, or under a condition on the way; "" where by all."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        if file is None:
            return ""
        is_offered = self.reached.is_library and not is_in_function(file, span)
        if role_of(path) == "test" or (not is_offered and self.shown.is_for_tests(file, span)):
            return IN_TEST
        return AT_TIMES if self.conditions(file, span) else ""

    def met_by_importers(self, file: PythonFile) -> Met:
        """Return when a module is imported that functions alone import, as an optional part of a library."""
        uses = self.reached.uses.get(self.installed.names.get(file.path, ""), [])
        if not uses or self.reached.is_wanted(file.path) or not all(each.is_local for _, each in uses):
            return "maybe"
        found = {self.as_shown(other, each.span) for other, each in uses}
        return "maybe" if "maybe" in found else min(found, key=MILDER.index)

    def is_unwanted(self, file: PythonFile) -> bool:
        """Return whether only functions that no program leads to import a module."""
        uses = self.reached.uses.get(self.installed.names.get(file.path, ""), [])
        idle = (each.is_local and not self.definitions.leads_to(other, each.span) for other, each in uses)
        return bool(uses) and all(idle) and not self.reached.is_wanted(file.path)

    def is_conditional(self, path: str, span: Span) -> bool:
        """Return whether a place is in a branch of its function, or in a module that others import under `try`."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        return file is not None and (is_under_condition(file, span) or self.reached.is_optional(path))

    def is_idle(self, file: PythonFile, span: Span) -> bool:
        """Return whether no program of the package leads to a place."""
        is_left = self.reached.is_left(file.path) or self.uncalled.has(file.path, span)
        return is_left or not self.definitions.leads_to(file, span) or self.is_unwanted(file)

    def is_by_path(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is under `if __name__ == '__main__'` of a module that an entry point starts."""
        guards = [each for each in file.tree.body if isinstance(each, ast.If) and is_guard(each)]
        is_under = any(file.span(part).holds(span) for each in guards for part in each.body)
        rows = self.table.of("executable") if is_under else ()
        is_program = any(row.source == file.path and not row.entry for row in rows)
        return is_under and not is_program and self.installed.names.get(file.path) in self.reached.entries

    def certain_spans(self, file: PythonFile) -> frozenset[Span]:
        """Return where the names stand that a program or a module reads whenever it is started or imported.

        None in a module of a library that nothing here comes to: no start ends there, but of who may import it.
        """
        module, rows = self.installed.names.get(file.path, ""), [*self.table.of("executable")]
        is_program = any(row.source == file.path and not row.entry for row in rows)
        is_started = (is_program or module in self.reached.started) and not self.reached.is_left(file.path)
        is_met = is_started and not self.unimported.is_by_nobody(file.path)
        if not is_met or self.reached.is_optional(file.path) or self.is_unwanted(file):
            return frozenset()
        entries = [row.entry.partition(":")[2] for row in rows if row.entry.partition(":")[0] == module]
        nodes = certain_nodes(file, entries, is_program=is_program)
        return frozenset(file.span(each) for each in nodes_of_kind(file.tree, ast.Name) if id(each) in nodes)

    def is_in_idle_function(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is in a function of a file that nothing calls, and that no other file takes."""
        taken = {name for _, other in self.run.files for each in other.imports for name in each.names}
        names = {row.entry.partition(":")[2] for row in self.table.of("executable")}
        for each in unreached_functions(file, names | taken):
            around = file.span(each)
            if around.holds(span) and not self.is_read_elsewhere(file, each.name):
                return True
        return False

    def is_read_elsewhere(self, file: PythonFile, name: str) -> bool:
        """Return whether another file has a name as an attribute: `module.name`."""
        return any(
            each.attr == name
            for _, other in self.run.files
            if other is not file
            for each in nodes_of_kind(other.tree, ast.Attribute)
        )
