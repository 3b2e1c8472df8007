"""Paths of a package that CMake commands make, when they configure or when they build."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from .cmake_project import CMake

WRITES = {
    "configure_file": 1, "configure_package_config_file": 1, "write_basic_package_version_file": 0, "em_expand": 3,
    "generate_export_header": -1,
}  # fmt: skip
"""Commands that write a file, and which argument names it."""
RUNS = frozenset({"add_custom_command", "add_custom_target", "execute_process"})
"""Commands that run a program, which may write what it is given."""
FETCHES = frozenset({"externalproject_add", "fetchcontent_declare", "fetchcontent_populate", "cpmaddpackage"})
FOLDER_KEYWORDS = ("SOURCE_DIR", "BINARY_DIR", "INSTALL_DIR", "DOWNLOAD_DIR", "PREFIX")
OUTPUT_KEYWORDS = ("OUTPUT", "BYPRODUCTS", "EXPORT_FILE_NAME", "DESTINATION", *FOLDER_KEYWORDS)
OTHER_KEYWORDS = ("COMMAND", "DEPENDS", "WORKING_DIRECTORY", "COMMENT", "VERBATIM", "MAIN_DEPENDENCY", "ARGS", "TARGET",
                  "POST_BUILD", "PRE_BUILD", "PRE_LINK", "SOURCES", "ALL")  # fmt: skip
WRITES_FILES = frozenset({"WRITE", "APPEND", "GENERATE", "COPY", "DOWNLOAD", "TOUCH", "CONFIGURE", "COPY_FILE",
                          "CREATE_LINK", "RENAME", "MAKE_DIRECTORY", "ARCHIVE_EXTRACT"})  # fmt: skip
ASKS = frozenset({"git", "hg", "date", "uname", "hostname", "pkg-config", "echo", "which", "test", "lsb_release"})
"""Programs that are run for what they print."""


@dataclass(frozen=True)
class MadePaths:
    cmake: CMake

    def is_made(self, path: str) -> bool:
        """Return whether a command, or a build that it starts, may make a file or folder of the package."""
        if path in self.written or posixpath.basename(path) in self.written_names:
            return True
        below = any(each.startswith(f"{path}/") for each in self.written)
        return below or any(f"{path}/".startswith(f"{folder}/") for folder in self.filled if folder)

    @property
    def is_worked_in(self) -> bool:
        """Whether a program is run in the package's own folder, or is given it: then it may make anything."""
        return "" in self.filled

    @property
    def calls(self) -> tuple[EvaluatedCommand, ...]:
        return self.cmake.calls + self.cmake.unreachable

    @cached_property
    def written(self) -> frozenset[str]:
        """The files and folders of the package that commands write."""
        found = (path_in_package(word.text, call.folder) for call in self.calls for word in files_written_by(call))
        return frozenset(path for path in found if path)

    @cached_property
    def written_names(self) -> frozenset[str]:
        """The names of all files that commands write, wherever; what is copied keeps its name."""
        words = [word for call in self.calls for word in files_written_by(call)]
        words += [word for call in self.calls if is_copy(call) for word in call.words[1:]]
        return frozenset(posixpath.basename(word.text) for word in words if not word.text.endswith("\0"))

    @cached_property
    def filled(self) -> frozenset[str]:
        """The folders, "" for the package itself, that a command fills, or that a program is run in or is given."""
        words = [(word.text, call) for call in self.calls for word in folders_filled_by(call)]
        found = (path_in_package(text, call.folder) for text, call in words if text)
        return frozenset(path for path in found if path is not None and not self.cmake.package_files.has_file(path))


def is_copy(call: EvaluatedCommand) -> bool:
    return call.name == "file" and call.texts[:1] in (("COPY",), ("ARCHIVE_EXTRACT",))


def asks_only(call: EvaluatedCommand) -> bool:
    """Return whether all programs that a call runs only print something."""
    programs = {posixpath.basename(after) for before, after in pairwise(call.texts) if before == "COMMAND"}
    return bool(programs) and programs <= ASKS


def files_written_by(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the names of the files that a command writes when it configures or builds."""
    if call.name in WRITES and WRITES[call.name] >= 0:
        yield from call.words[WRITES[call.name] :][:1]
    if call.name == "file" and call.words and call.texts[0] in WRITES_FILES and not is_copy(call):
        yield from call.words[1:]
    if call.name == "set_source_files_properties" and "GENERATED" in call.texts:
        yield from call.words[: call.texts.index("PROPERTIES")] if "PROPERTIES" in call.texts else ()
    if call.name in RUNS or call.name in FETCHES or call.name == "generate_export_header":
        yield from values_of(call, OUTPUT_KEYWORDS)


def folders_filled_by(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the folders into which a command puts files of names that are not known."""
    if call.name == "file" and call.texts[:1] == ("MAKE_DIRECTORY",):
        yield from call.words[1:]
    elif is_copy(call) or call.name in FETCHES:
        yield from values_of(call, ("DESTINATION", *FOLDER_KEYWORDS))
    elif call.name in RUNS and not asks_only(call):
        yield from call.words


def values_of(call: EvaluatedCommand, keywords: tuple[str, ...]) -> Iterator[Word]:
    _, values, _ = flags_and_values(call.words, (), (), (*OUTPUT_KEYWORDS, *OTHER_KEYWORDS))
    for keyword in keywords:
        yield from values.get(keyword, [])
