"""The Python files of a package, each parsed once and only when asked for."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles, ReaderInput
from ..languages.cmake.evaluated_command import path_in_package
from ..languages.python.file import PythonFile, parse_python
from ..lazy_regex import regex
from ..light_dataclasses import dataclass, field
from ..unreadable import Unreadable, UnreadableError
from .cmake.cmake_project import CMake
from .file_role import role_of
from .install_table import InstallTable
from .setup.setup_py import SetupPy

TEST = regex(r"test_.*\.py|.*_test\.py")
"""The names by which pytest finds tests."""
REGISTERS = frozenset({"ament_add_pytest_test", "ament_add_test", "add_test", "add_launch_test", "add_ros_test"})


@dataclass(frozen=True)
class PythonModules:
    files: PackageFiles
    parsed: dict[str, PythonFile | Unreadable] = field(default_factory=dict)

    def read(self, path: str) -> PythonFile | Unreadable:
        """Return a parsed file, or why it can't be parsed."""
        if path not in self.parsed:
            try:
                self.parsed[path] = parse_python(self.files.source(path))
            except UnreadableError as error:
                self.parsed[path] = error.unreadable
        return self.parsed[path]

    def skip(self, unreadable: Unreadable) -> None:
        """Keep no syntax tree of a file that is said to be skipped."""
        self.parsed[unreadable.path] = unreadable

    def at(self, path: str) -> PythonFile | None:
        """Return the file at a path; None where there is none, or none that can be parsed."""
        found = self.read(path) if self.files.exists(path) else None
        return found if isinstance(found, PythonFile) else None


def read_modules(reading: ReaderInput) -> Iterator[PythonModules]:
    yield PythonModules(reading.files)


def read_installed_modules(reading: ReaderInput) -> Iterator[PythonFile | Unreadable]:
    """Read every module and script that is installed, and every test: what can't be parsed fails when it is run."""
    setup, modules = reading.parts(SetupPy).only, reading.parts(PythonModules).only
    table = reading.parts(InstallTable).only
    rows = table.rows if table is not None else ()
    paths = {row.source for row in rows if row.what in ("module", "executable") and row.source.endswith(".py")}
    paths |= set(setup.modules.values()) if setup is not None else set()
    if modules is not None:
        paths |= with_helpers(modules, set(tests_of(reading)))
        for path in sorted(paths):
            yield modules.read(path)


def with_helpers(modules: PythonModules, tests: set[str]) -> set[str]:
    """Return tests with the modules next to them that they import by a bare name."""
    found = set(tests)
    for path in tests:
        file = modules.at(path)
        folder = path.rpartition("/")[0]
        next_to = (
            {f"{folder}/{each.module}.py" for each in file.imports if not each.level} if file and folder else set()
        )
        found |= {helper for helper in next_to if modules.files.exists(helper)}
    return found


def tests_of(reading: ReaderInput) -> Iterator[str]:
    """Yield the files that `colcon test` certainly reads: pytest by their names, CTest as CMake registers them."""
    if reading.parts(SetupPy).only is not None:
        names = (path for path in reading.files.paths if TEST.fullmatch(path.rpartition("/")[2]))
        yield from (path for path in names if role_of(path) == "test")
    cmake = reading.parts(CMake).only
    for call in cmake.calls if cmake is not None else ():
        if call.name in REGISTERS:
            paths = {path for word in call.words if (path := path_in_package(word.text, call.folder))}
            yield from (path for path in paths if path.endswith(".py") and reading.files.exists(path))
