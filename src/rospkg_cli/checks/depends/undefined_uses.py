"""Names that a package's Python code uses and that nothing binds (DEP117)."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator
from functools import cached_property
from typing import Literal

from ...languages.python.branches import is_under_condition
from ...languages.python.certain_nodes import certain_nodes, is_guard
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.undefined_names import UndefinedName, is_in_branch, undefined_names
from ...languages.python.unreached_functions import unreached_functions
from ...languages.python.unreached_places import is_unreached
from ...light_dataclasses import dataclass
from ...package.file_role import Role, is_set_aside, role_of
from ...package.install_table import InstallTable
from ...source import Span
from ..behind_spin import is_behind_spin
from ..installed_modules import InstalledModules
from ..interfaces.seldom_run import is_in_handler
from ..interfaces.uncalled_methods import UncalledMethods
from ..module_attributes import AbsentAttribute, absent_attributes
from ..reached_definitions import ReachedDefinitions
from ..reached_modules import ReachedModules
from ..run_imports import RunImports

When = Literal["certainly", "maybe", "branch", "late", "never", "aside"]
"""When a name is used: at every start or import, in some runs, under a condition or after another failure, behind a
`spin` that Ctrl-C leaves, where nothing leads, in what nothing installs."""

ORDER: tuple[When, ...] = ("certainly", "maybe", "branch", "late", "never", "aside")
OF_LAUNCH = frozenset({"generate_launch_description", "generate_test_description"})
PYTHON_2 = frozenset(
    "unicode xrange raw_input basestring long unichr reduce file cmp execfile buffer reload apply intern".split()
)
"""Builtins of Python 2, which files for both ask for behind a look at the version."""
GIVEN = frozenset(
    "_ ngettext get_ipython display profile reveal_type WindowsError exit quit copyright credits license help "
    "aiter anext EncodingWarning BaseExceptionGroup ExceptionGroup PythonFinalizationError".split()
)
"""What translations, notebooks, profilers, `site` and newer Pythons have among the builtins."""
BUILD_TOOL = "Import"
"""How a script of SCons asks for the names that it is given."""


@dataclass(frozen=True, slots=True)
class UndefinedUse:
    """A name that a file uses and that nothing binds, with its first use among those that are worst."""

    file: PythonFile
    found: UndefinedName
    others: tuple[UndefinedName, ...]
    when: When
    home: str
    """The module that the file imports and that has the name: `.qos`; "" where none is known."""


@dataclass(frozen=True)
class UndefinedUses:
    run: RunImports
    table: InstallTable
    installed: InstalledModules
    reached: ReachedModules
    uncalled: UncalledMethods
    definitions: ReachedDefinitions

    @property
    def files(self) -> Iterator[tuple[Role, PythonFile]]:
        """The files that are installed, or may be run where they lie, without those of LCH013."""
        for role, file in self.run.files:
            may_run = role != "aside" or (role_of(file.path) != "aside" and not is_set_aside(file.path))
            is_launched = role == "launch" and "__main__" in file.source.text
            if may_run and OF_LAUNCH.isdisjoint(file.functions) and not is_launched:
                yield role, file

    def all(self) -> Iterator[UndefinedUse]:
        for role, file in self.files:
            yield from self.of(file, role)

    @cached_property
    def local(self) -> frozenset[str]:
        """The names of the modules and folders of the package."""
        return frozenset(part.removesuffix(".py") for path in self.installed.files.paths for part in path.split("/"))

    def absent(self) -> Iterator[tuple[PythonFile, AbsentAttribute, When]]:
        """Yield the names that modules of the standard library do not have, and when they are read."""
        for role, file in self.files:
            for each in absent_attributes(file, self.local):
                found = UndefinedName(each.name, each.root, frozenset())
                if not is_unreached(file, found.span):
                    yield file, each, self.when_in(role, file, found, self.certain_spans(file))

    def of(self, file: PythonFile, role: Role) -> Iterator[UndefinedUse]:
        uses: dict[str, list[UndefinedName]] = {}
        for found in undefined_names(file, everywhere=True):
            is_told = found.name not in GIVEN and not self.is_for_python_2(file, found)
            if is_told and not is_unreached(file, found.span):
                uses.setdefault(found.name, []).append(found)
        if not uses or BUILD_TOOL in uses:
            return
        certain = self.certain_spans(file)
        for name, places in uses.items():
            if not self.may_come_by_star(file, name):
                times = [self.when_in(role, file, each, certain) for each in places]
                when = min(times, key=ORDER.index)
                first = places[times.index(when)]
                others = tuple(each for each in places if each is not first)
                yield UndefinedUse(file, first, others, when, self.home(file, name))

    def is_for_python_2(self, file: PythonFile, found: UndefinedName) -> bool:
        return found.name in PYTHON_2 and (found.is_caught or is_in_branch(file, found.span))

    def may_come_by_star(self, file: PythonFile, name: str) -> bool:
        """Return whether a star import may bind a name: of a foreign module, or of an own one that has it."""
        stars = (each for each in file.imports if "*" in each.names)
        modules = [self.installed.absolute(each, file.path) for each in stars]
        return any(each not in self.installed.sources or self.installed.offers(each, name) for each in modules)

    def when_in(self, role: Role, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        by_role: dict[Role, When] = {"test": "maybe", "aside": "aside"}
        return by_role.get(role) or self.when(file, found, certain)

    def when(self, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        if found.span in certain and not (found.is_annotation or found.is_caught):
            return "certainly"
        if self.is_idle(file, found.span):
            return "never"
        if is_behind_spin(file, found.span):
            return "late"
        is_seldom = is_in_handler(file, found.span) or self.definitions.is_turned_off(file, found.span)
        is_seldom = is_seldom or self.is_by_path(file, found.span)
        return "branch" if is_seldom else "maybe"

    def of_attribute(self, role: Role, file: PythonFile, found: UndefinedName, certain: Collection[Span]) -> When:
        """Return when an attribute is read of an object, of which less is known than of a name."""
        when = self.when_in(role, file, found, certain)
        return "branch" if when == "maybe" and is_under_condition(file, found.span) else when

    def is_idle(self, file: PythonFile, span: Span) -> bool:
        """Return whether nothing in the package leads to a place."""
        is_left = self.reached.is_left(file.path) or self.uncalled.has(file.path, span)
        return is_left or not self.definitions.leads_to(file, span) or self.is_in_idle_function(file, span)

    def is_by_path(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is under `if __name__ == '__main__'` of a module that an entry point starts."""
        guards = [each for each in file.tree.body if isinstance(each, ast.If) and is_guard(each)]
        is_under = any(file.span(part).holds(span) for each in guards for part in each.body)
        rows = self.table.of("executable") if is_under else ()
        is_program = any(row.source == file.path and not row.entry for row in rows)
        return is_under and not is_program and self.installed.names.get(file.path) in self.reached.entries

    def certain_spans(self, file: PythonFile) -> frozenset[Span]:
        """Return where the names stand that a program or a module reads whenever it is started or imported."""
        module, rows = self.installed.names.get(file.path, ""), [*self.table.of("executable")]
        is_program = any(row.source == file.path and not row.entry for row in rows)
        if not is_program and module not in self.reached.started:
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

    def home(self, file: PythonFile, name: str) -> str:
        """Return the own module, as a file imports it, in which a name is defined."""
        for each in file.imports:
            source = self.installed.sources.get(self.installed.absolute(each, file.path), "")
            other = self.run.modules.at(source) if source and each.names else None
            if other is not None and name in other.definitions:
                return "." * each.level + each.module
        return ""
