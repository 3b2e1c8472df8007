"""Files for run time that are not installed, and files that the build writes."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ..files import ReaderInput
from ..languages.cmake.evaluated_command import EvaluatedCommand
from ..languages.cmake.values import UNKNOWN
from ..ros.share_layout import FOLDERS
from .cmake.cmake_project import CMake
from .cmake.intended_paths import intended_paths
from .cmake.made_paths import files_written_by
from .cmake.referenced_paths import ReferencedPaths
from .install_table import InstallTable

RUNS = frozenset({"execute_process", "add_custom_command", "add_custom_target"})
CODE = (".h", ".hpp", ".hh", ".c", ".cc", ".cpp", ".cxx", ".cmake", ".in", ".txt", ".so", ".a")


def uninstalled_files(reading: ReaderInput) -> frozenset[str]:
    """Return the files in the folders for run time that nothing installs."""
    table = reading.parts(InstallTable).only
    if table is None:
        return frozenset()
    sources = {row.source for row in table.rows}
    found = (path for folder in FOLDERS for path in reading.files.below(folder))
    return frozenset(path for path in found if path not in sources)


def made_files(reading: ReaderInput) -> frozenset[str]:
    """Return the names of the files that CMake writes, and of those that it installs and that are missing (a rule
    reports those with a similar name).

    `*` stands for the unknown parts of a name, and for any file of a folder.
    """
    cmake = reading.parts(CMake).only
    if cmake is None:
        return frozenset()
    named = ReferencedPaths(cmake)
    texts = [text for call in named.made.calls for text in made_by(call)]
    texts += [each.path for each in named.absent() if each.use == "install"]
    texts += intended_paths(cmake)
    names = {posixpath.basename(text).replace(UNKNOWN, "*") for text in texts}
    folders = {f"*{posixpath.basename(each.path)}/*" for each in named.absent() if each.use == "folder"}
    return frozenset(name for name in names if name.strip("*.") and not name.endswith(CODE)) | folders


def made_by(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the paths that a call may write: where it runs a program, all that it hands to it."""
    yield from (word.text for word in files_written_by(call))
    if call.name in RUNS:
        yield from (text for text in call.texts if "." in posixpath.basename(text))
    elif call.name.startswith("xacro_"):
        yield from (text.removesuffix(".xacro") for text in call.texts)
