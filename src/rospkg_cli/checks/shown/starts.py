"""Rule input: what is shown to be run first: programs, tests and launch files."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.certain_nodes import is_guard
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.launch_evaluator import ENTRIES
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..python.installed_modules import InstalledModules
from ..python.run_imports import RunImports
from ..python.unrun_tests import SOUGHT, is_never_run
from ..reached_modules import ReachedModules
from ..started_by_path import python_files_in
from .meanings import Meanings, Own

STARTING = (".sh", ".bash", ".launch", ".xml", ".service", ".yaml", ".yml", ".py")
OF_CASES = frozenset({"setUp", "tearDown", "setUpClass", "tearDownClass", "setup_method", "teardown_method"})
OF_TESTS = frozenset({"setup_module", "teardown_module", "setup_function", "pytest_configure"})


@dataclass(frozen=True)
class Start:
    unit: Own
    conditions: int = 0
    is_program: bool = False
    """Whether a module is started by its path."""
    is_whole: bool = False
    """Whether it begins a program, of which all is to be seen, and no part that others take."""


@dataclass(frozen=True)
class Starts:
    files: PackageFiles
    table: InstallTable
    installed: InstalledModules
    run: RunImports
    facts: PackageFacts
    workspace: Workspace
    reached: ReachedModules
    cmake: CMake | None = None

    def all(self, meanings: Meanings, *, with_tests: bool = True) -> Iterator[Start]:
        yield from self.programs(meanings)
        yield from self.taken(meanings)
        for role, file in self.run.files:
            if role == "launch":
                yield Start(Own(file, file.tree))
                yield from (Start(each) for each in functions(file, ENTRIES))
            elif self.is_test(file):
                yield from tests_in(file, meanings) if with_tests else ()
            elif self.is_by_path(file):
                yield Start(Own(file, file.tree), int(self.table.knows("executable")), is_program=True, is_whole=True)

    def programs(self, meanings: Meanings) -> Iterator[Start]:
        """Yield the installed programs, and the functions of entry points."""
        for row in self.table.of("executable"):
            module, _, name = row.entry.partition(":")
            file = self.run.modules.at(self.installed.sources.get(module, "") if row.entry else row.source)
            if file is None:
                continue
            yield Start(Own(file, file.tree), int(row.maybe), is_program=not row.entry, is_whole=True)
            definition = meanings.in_file(file).get(name.partition(".")[0]) if name else None
            yield from [Start(definition, int(row.maybe), is_whole=True)] if definition is not None else []

    def taken(self, meanings: Meanings) -> Iterator[Start]:
        """Yield what other packages of the workspace import."""
        others = (each for each in self.workspace.packages if each.name != self.facts.name)
        for module, name in sorted({taken for each in others for taken in each.taken_names}):
            source = self.installed.sources.get(module, "")
            file = self.run.modules.at(source) if source else None
            if file is not None:
                yield Start(Own(file, file.tree))
                definition = meanings.in_file(file).get(name)
                yield from [Start(definition)] if definition is not None else []

    @cached_property
    def has_programs(self) -> bool:
        return any(True for _ in self.table.of("executable"))

    def is_by_path(self, file: PythonFile) -> bool:
        """Return whether a module may be started by its path: a launch file or the like names it, or the package has no
        known program.

        A script that only a page names does not count where there are programs, nor does one that others import.
        """
        if posixpath.basename(file.path) in self.named:
            return True
        has_guard = any(isinstance(each, ast.If) and is_guard(each) for each in file.tree.body)
        is_only = has_guard and not (self.has_programs and self.table.knows("executable"))
        return is_only and not self.is_imported(file)

    def is_imported(self, file: PythonFile) -> bool:
        """Return whether another module imports a file; a test may import a program."""
        uses = self.reached.imports.uses.get(self.installed.names.get(file.path, ""), [])
        return any(other is not file and role_of(other.path) != "test" for other, _ in uses)

    @cached_property
    def named(self) -> frozenset[str]:
        """The names of Python files that texts have which start programs."""
        paths = (each for each in self.files.paths if each.endswith(STARTING))
        others = (each for each in paths if each not in self.installed.names and each != "setup.py")
        return frozenset(name for each in others for name in python_files_in(live_text(self.files, each)))

    def is_test(self, file: PythonFile) -> bool:
        """Return whether `colcon test` collects what a file defines: CMake may name any, pytest looks for names."""
        name, build_type = posixpath.basename(file.path), self.facts.build_type
        testing = [each for each in self.cmake.calls if "test" in each.name] if self.cmake is not None else []
        if any(name in text for each in testing for text in each.texts):
            return True
        if not (SOUGHT.fullmatch(name) or name == "conftest.py"):
            return False
        if build_type == "ament_python":
            asked = (self.files.readable_text(each) for each in ("setup.py", "setup.cfg") if self.files.exists(each))
            return any("pytest" in each for each in asked)
        return self.cmake is not None and not is_never_run(file.path, self.files, self.cmake, build_type)


def functions(file: PythonFile, names: tuple[str, ...]) -> Iterator[Own]:
    return (Own(file, each) for each in file.tree.body if isinstance(each, FunctionNode) and each.name in names)


def tests_in(file: PythonFile, meanings: Meanings) -> Iterator[Start]:
    """Yield what pytest runs of a file: functions, methods of classes for tests, imported ones too, and fixtures."""
    yield Start(Own(file, file.tree))
    definition = [each for each in meanings.in_file(file).values() if isinstance(each.node, ast.ClassDef)]
    for owner in (Own(file, file.tree), *definition):
        is_searched = not isinstance(owner.node, ast.ClassDef) or is_case(owner.node)
        for each in owner.node.body if is_searched else ():
            if isinstance(each, FunctionNode) and is_of_tests(each):
                yield Start(Own(owner.file, each))


def is_case(owner: ast.ClassDef) -> bool:
    return owner.name.startswith("Test") or any("TestCase" in ast.unparse(base) for base in owner.bases)


def is_of_tests(function: FunctionNode) -> bool:
    is_fixture = any("fixture" in ast.unparse(each) for each in function.decorator_list)
    return is_fixture or function.name.startswith("test") or function.name in OF_CASES | OF_TESTS | {*ENTRIES}
