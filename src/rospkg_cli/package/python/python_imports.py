"""What each Python file of a package imports that is not the package's own."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.python.file import PythonFile, parse_python
from ...languages.python.imports import Import
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...source import Source
from ...unreadable import UnreadableError
from ..file_role import Role, role_of
from ..install_table import InstallTable
from ..launch.launch_file import LaunchFile
from ..python_modules import PythonModules
from ..setup.setup_py import SetupPy
from .installed_python import InstalledPython
from .modules_of_tests import modules_of_tests
from .node_calls import DescribedNode, described_nodes
from .own_modules import OwnModules, own_modules

LAUNCH_TEST = "generate_test_description"
LAUNCH_PYTEST = "launch_pytest"

VARIABLE = regex(r"@(\w+)@")


@dataclass(frozen=True)
class PythonImports:
    """What one file imports that is not its package's own."""

    path: str
    role: Role
    imports: tuple[Import, ...]
    nodes: tuple[DescribedNode, ...] = ()


@dataclass(frozen=True)
class PackageImports:
    """Every Python file of a package that can be read; `is_complete` says whether all of them could."""

    files: tuple[PythonImports, ...] = ()
    is_complete: bool = True


def read_package_imports(reading: ReaderInput) -> Iterator[PackageImports]:
    """Read the imports of every Python file; what is broken is left out here and reported elsewhere."""
    setup = reading.parts(SetupPy).only
    started = [each.module for each in setup.entry_points] if setup is not None else []
    own, table = own_modules(reading.files), reading.parts(InstallTable).only
    installed = InstalledPython(reading.files, table, started)
    modules = reading.parts(PythonModules).only
    assert modules is not None
    reading.parts(LaunchFile)  # those that are skipped are not parsed for their imports, whichever is asked for first
    found: list[PythonImports] = []
    installed_files: dict[str, PythonFile] = {}
    complete = True
    for path in reading.files.paths:
        if is_python(reading.files, path):
            file, role = modules.at(path), role_of(path)
            if file is None:
                complete = False
                continue
            if role == "aside" and path in installed.sources:
                role = "run"  # whatever its folder is called: CMake or setup.py installs it
            used = installed.has(path) if role == "run" else role != "test" or installed.is_test(path)
            role = "aside" if not used else "test" if is_launch_test(file) else role
            if role == "run":
                installed_files[path] = file
            found.append(PythonImports(path, role, foreign(file, own), tuple(described_nodes(file))))
        elif path.endswith(".py.in") and role_of(path) == "test" and installed.is_test(path):
            file = read_template(reading.files, path)
            found += [PythonImports(path, "test", foreign(file, own))] if file is not None else []
    tests = modules_of_tests(installed_files, table)
    yield PackageImports(tuple(replace(each, role="test") if each.path in tests else each for each in found), complete)


def is_launch_test(file: PythonFile) -> bool:
    """Return whether a file is a test for launch_testing or launch_pytest, wherever it is and whatever its name."""
    return LAUNCH_TEST in file.functions or any(each.module.partition(".")[0] == LAUNCH_PYTEST for each in file.imports)


def read_template(files: PackageFiles, path: str) -> PythonFile | None:
    """Read the template of a test for configure_file, with a name in the place of every `@VARIABLE@`."""
    try:
        return parse_python(Source(path, VARIABLE.sub(r"_\1_", files.source(path).text)))
    except UnreadableError:
        return None


def foreign(file: PythonFile, own: OwnModules) -> tuple[Import, ...]:
    return tuple(each for each in file.imports if not each.level and not own.has(each.module, file.path))


def is_python(files: PackageFiles, path: str) -> bool:
    """Return whether a file is Python by its suffix, or by the first line of a script without one."""
    name = path.rpartition("/")[2]
    if "." in name:
        return name.endswith(".py")
    if not files.is_executable(path):
        return False
    try:
        first = files.source(path).text.partition("\n")[0]
    except UnreadableError:
        return False
    return first.startswith("#!") and "python" in first
