"""Headers that a package has for other packages, and those that its build may make."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN
from ...lazy_regex import regex
from .build import is_built_with_cmake
from .cmake_project import CMake
from .copied_files import copied_files
from .foreign_commands import foreign_commands
from .made_paths import FETCHES, MadePaths, files_written_by

HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp", ".inl", ".cuh", ".impl", ".tcc", ".ii")
GENERATES = regex(
    r"(?!generate_(?:parameter_|export_))generate_\w+|protobuf_\w+|grpc_\w+|flatbuffers_\w+|swig_\w+|qt\d?_wrap_\w+"
)
PLACE = "include/"
EXPORTED = regex(r"(?:^|[:;/])include/([\w./-]+)")
RUNS = ("execute_process", "add_custom_command", "add_custom_target")


def header_files(reading: ReaderInput) -> frozenset[str]:
    """Return the headers below the `include/` folders of a package, relative to them."""
    return frozenset(below_include(reading.files))


def renamed_headers(cmake: CMake, below: frozenset[str]) -> Iterator[str]:
    """Yield the paths that headers get when they are installed a folder deeper, or when a deeper folder is exported.

    Those of `include/my_pkg/my_pkg/` are found by the paths that they have here.
    """
    scope, exported = f"{cmake.project_name}/", exported_folders(cmake)
    for path in installed_headers(cmake):
        rest = path.removeprefix(scope)
        if rest != path and rest in below and not rest.startswith(scope):
            yield path
        short = (path.removeprefix(folder) for folder in exported if path.startswith(folder))
        yield from (each for each in short if each.startswith(scope) and each not in below)


def exported_folders(cmake: CMake) -> frozenset[str]:
    """Return the folders below include/ that the package exports, relative to it."""
    exported = [text for call in cmake.named("ament_export_include_directories") for text in call.texts]
    words = (text for call in cmake.named("target_include_directories") for text in call.texts)
    exported += (text for text in words if "INSTALL_INTERFACE" in text)
    for call in cmake.named("install"):
        exported += call.texts[call.texts.index("INCLUDES") :] if "INCLUDES" in call.texts else ()
    found = (EXPORTED.search(text) for text in exported)
    return frozenset(f"{each[1].rstrip('/')}/" for each in found if each is not None)


def has_other_headers(reading: ReaderInput) -> bool:
    """Return whether the build may make headers, or others find some by other paths than they have here."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return is_built_with_cmake(reading)
    known, scope = header_files(reading), f"{cmake.project_name}/"
    others = (path for path in installed_headers(cmake) if not {path, path.removeprefix(scope)} & known)
    is_made = may_make_headers(cmake) or bool(made_header_names(cmake))
    return is_made or next(others, None) is not None or next(renamed_headers(cmake, known), None) is not None


def installed_headers(cmake: CMake) -> Iterator[str]:
    """Yield the headers that install rules take to include/, relative to it."""
    for rule in cmake.installs:
        if f"{rule.destination}/".startswith(PLACE):
            copies = (copy.destination.removeprefix(PLACE) for copy in copied_files(rule, cmake.package_files))
            yield from (path for path in copies if path.endswith(HEADERS))


def below_include(files: PackageFiles) -> list[str]:
    inside = (f"/{path}".partition("/include/")[2] for path in files.paths if path.endswith(HEADERS))
    return [path for path in inside if path]


def may_make_headers(cmake: CMake) -> bool:
    """Return whether a build may make headers of any name."""
    if not cmake.is_complete or cmake.reads_unknown_files or MadePaths(cmake).filled:
        return True
    if any(UNKNOWN in word.text for call in cmake.calls for word in files_written_by(call)):
        return True
    if any(call.name in FETCHES or GENERATES.fullmatch(call.name) for call in cmake.calls):
        return True
    return next(foreign_commands(cmake), None) is not None


def made_header_names(cmake: CMake) -> frozenset[str]:
    """Return the names of the headers that a build makes, as far as they are known."""
    written = MadePaths(cmake).written_names
    handed = {posixpath.basename(text) for call in cmake.named(*RUNS) for text in call.texts}
    made = {name for call in cmake.calls for name in (made_by(call),) if name}
    return frozenset(name for name in {*written, *handed, *made} if name.endswith(HEADERS))


def made_by(call: EvaluatedCommand) -> str:
    """Return the header that a command of ament or CMake makes under a name of its own."""
    if call.name == "generate_parameter_library" and call.words:
        return f"{call.texts[0]}.hpp"
    if call.name == "generate_export_header" and call.words:
        return f"{call.texts[0].lower()}_export.h"
    return ""
