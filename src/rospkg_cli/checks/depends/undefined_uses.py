"""Names that a package's Python code uses and that nothing binds (DEP117)."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.place_kinds import is_in_branch
from ...languages.python.undefined_names import UndefinedName, undefined_names
from ...languages.python.unreached_places import is_unreached
from ...light_dataclasses import dataclass
from ...package.file_role import Role, is_set_aside, role_of
from ...ros.module_attributes import IN_FOXY
from ..python.installed_modules import InstalledModules
from ..python.module_attributes import AbsentAttribute, absent_attributes
from ..python.run_imports import RunImports
from ..reached_places import ReachedPlaces
from ..repository.older_distribution import OlderDistribution
from .use_times import ORDER, UseTimes, When

OF_LAUNCH = frozenset({"generate_launch_description", "generate_test_description"})

PYTHON_2 = frozenset(
    "unicode xrange raw_input basestring long unichr reduce file cmp execfile buffer reload apply intern".split()
)
"""Builtins of Python 2, which files for both versions use after a check of the version."""

GIVEN = frozenset(
    "_ ngettext get_ipython display profile reveal_type WindowsError exit quit copyright credits license help "
    "aiter anext EncodingWarning BaseExceptionGroup ExceptionGroup PythonFinalizationError".split()
)
"""Builtins of translations, notebooks, profilers, `site` and newer Pythons."""

BUILD_TOOL = "Import"
"""The function by which a script of SCons gets the names that it is given."""


@dataclass(frozen=True, slots=True)
class UndefinedUse:
    """A name that a file uses and that nothing binds, with its first use among those that are worst."""

    file: PythonFile
    found: UndefinedName
    others: tuple[UndefinedName, ...]
    when: When
    home: str
    """The line that imports the name as a module that the file imports does, or from it; "" where none is known."""


@dataclass(frozen=True)
class UndefinedUses:
    run: RunImports
    installed: InstalledModules
    places: ReachedPlaces
    distribution: OlderDistribution

    @cached_property
    def times(self) -> UseTimes:
        return UseTimes(self.places)

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
                    yield file, each, self.times.of(role, file, found, self.places.certain.spans(file))

    def is_for_older(self, file: PythonFile, each: AbsentAttribute) -> bool:
        """Return whether a file is only for distributions whose Python still has a name."""
        return f"{each.module}.{each.name}" in IN_FOXY and self.distribution.is_for_unsupported(file.path)

    def of(self, file: PythonFile, role: Role) -> Iterator[UndefinedUse]:
        uses: dict[str, list[UndefinedName]] = {}
        for found in undefined_names(file, everywhere=True):
            is_unknown = found.name not in GIVEN and not self.is_for_python_2(file, found)
            if is_unknown and not is_unreached(file, found.span):
                uses.setdefault(found.name, []).append(found)
        if not uses or BUILD_TOOL in uses:
            return
        certain = self.places.certain.spans(file)
        for name, places in uses.items():
            if not self.may_come_by_star(file, name):
                times = [self.times.of(role, file, each, certain) for each in places]
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

    def home(self, file: PythonFile, name: str) -> str:
        """Return the line that imports a name from a module of the package of which a file imports other names."""
        for each in file.imports:
            source = self.installed.sources.get(self.installed.absolute(each, file.path), "")
            other = self.run.modules.at(source) if source and each.names else None
            if other is not None and name in other.definitions:
                return imported_as(other, name) or f"from {'.' * each.level}{each.module} import {name}"
        return ""


def imported_as(file: PythonFile, name: str) -> str:
    """Return the line by which a file itself imports a name from elsewhere; "" where it does not."""
    every: list[ast.Import | ast.ImportFrom] = [*nodes_of_kind(file.tree, ast.Import)]
    for node in (*every, *nodes_of_kind(file.tree, ast.ImportFrom)):
        for alias in node.names:
            if (alias.asname or alias.name) == name and not getattr(node, "level", 0):
                start = f"from {node.module} " if isinstance(node, ast.ImportFrom) else ""
                return f"{start}import {ast.unparse(alias)}"
    return ""
