"""Modules among the others that are tests: pytest or unittest runs them, and nothing that runs imports them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePosixPath

from ...languages.python.file import PythonFile
from ...lazy_regex import regex
from ..install_table import InstallTable

NAMED = regex(r"test_.*|.*_tests?")
"""What pytest looks for, by the stem of a file (`python_files`), and unittest's own habit."""

TEST_FUNCTION = "test_"
RUNNERS = frozenset({"pytest", "unittest"})


def modules_of_tests(files: Mapping[str, PythonFile], table: InstallTable | None) -> frozenset[str]:
    """Return those of some modules, by path, that are tests by their name and by what is in them.

    One that is an executable, or that a module imports which is no test, is used when the package runs; all may be
    where the executables are unknown.
    """
    found = {path for path, file in files.items() if is_of_tests(path, file)}
    if not found or table is None or not table.knows("executable"):
        return frozenset()
    rows = tuple(table.of("executable"))
    started = {row.source for row in rows} | {stem(row.entry.partition(":")[0].replace(".", "/")) for row in rows}
    imports = [each for path, file in files.items() if path not in found for each in file.imports]
    used = {each.module.rpartition(".")[2] for each in imports} | {name for each in imports for name in each.names}
    return frozenset(path for path in found if path not in started and stem(path) not in started | used)


def is_of_tests(path: str, file: PythonFile) -> bool:
    """Return whether a module is called like a test, and defines tests."""
    if not NAMED.fullmatch(stem(path)):
        return False
    functions = any(name.startswith(TEST_FUNCTION) for name in file.functions)
    return functions or any(each.module.partition(".")[0] in RUNNERS for each in file.imports)


def stem(path: str) -> str:
    return PurePosixPath(path).stem
