"""CMK106 headers-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.exported_headers import ExportedHeaders
from ...checks.cmake.exported_include_folders import ExportedIncludeFolders
from ...checks.cmake.header_sentences import lacking, not_exported, private
from ...checks.cmake.met_here import by_whom
from ...checks.cmake.private_includes import PrivateIncludes
from ...checks.cmake.unmatched_patterns import unmatched_patterns
from ...edits.cmake_commands import remove
from ...edits.cmake_install import install_headers
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.cmake.installed_headers import INCLUDES
from ...package.cmake.project_name import PACKAGE_ENDS
from ...rule import rule

LINES = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include/${PROJECT_NAME}>
)
install(TARGETS core EXPORT export_core
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
«ament_export_targets(export_core HAS_LIBRARY_TARGET)»
"""
INSTALL = "\ninstall(DIRECTORY include/\n  DESTINATION include/${PROJECT_NAME}\n)\n"
GOOD = (
    LINES.replace("«", "")
    .replace("»", "")
    .replace("  RUNTIME DESTINATION bin\n)\n", "  RUNTIME DESTINATION bin\n)\n" + INSTALL)
)
FILES = {"src/core.cpp": "int core() {return 1;}\n", "include/my_pkg/core.hpp": "#pragma once\nint core();\n"}


@rule(
    "CMK106",
    "headers-not-installed",
    over=ExportedHeaders,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "no package of the workspace that looks for this one is known to include its headers, or each "
        "that does has copies"
    },
    examples=(
        Example(
            bad={**FILES, "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package")},
            good={"CMakeLists.txt": CMAKE.replace("ament_package", GOOD + "ament_package")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def headers_not_installed(exported: ExportedHeaders) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages that export a library or include directories and install no headers.
    Only packages that have headers in `include/` are checked. It also finds `install(DIRECTORY include DESTINATION
    include)`, which makes a folder in the folder, and headers in `include/my_pkg/` where only `include` is exported
    (`$<INSTALL_INTERFACE:…>`, INCLUDES DESTINATION, `ament_export_include_directories()`), or the other way
    round; single headers of `include/` that another package of the workspace includes; and those that an installed one
    includes (`ui_window.h` of Qt, too).

    ## Why is this bad?
    This package builds. Another one that links the library stops with "No such file or directory" at the first
    `#include`. Where no library is exported, there is nothing to link either: then take the export out.

    ## When it is quiet
    Where an install rule or CMake itself can't be evaluated, in `ament_auto_package()`, for a package that exports only
    plugins as targets, and as soon as one header is installed, but for one that another package includes and that has
    no CMake file that looks elsewhere. It is a warning where a package of the workspace looks for this one, includes
    one of the headers and has no copy of it; an info elsewhere, also for what is released: its users build.
    """
    cmake = exported.headers.package.cmake
    if not exported.headers.package.is_ament:
        return
    yield from misplaced(exported)
    if exported.headers.are_uninstalled():
        unmatched = {path for each in unmatched_patterns(cmake) for path in each.others}  # CMK129 reports the pattern
        yield from none_installed(exported) if unmatched.isdisjoint(exported.headers.offered) else ()
    elif wanted := exported.wanted():
        call = [each for each in cmake.calls if each.name.endswith(PACKAGE_ENDS)][-1]
        yield Hit(call.path, call.command.span, lacking(*wanted))
    yield from left_behind(exported)


def left_behind(exported: ExportedHeaders) -> Iterator[Hit]:
    """Yield what installed headers include and nothing installs, in one hit."""
    for each, *others in filter(None, [list(PrivateIncludes(exported).all())]):
        level = None if exported.is_included(each.file.path) else Severity.INFO
        related = tuple(Related(other.file.path, other.include.span, "and here") for other in others)
        yield Hit(each.file.path, each.include.span, private(each, len(others)), level, related)


def none_installed(exported: ExportedHeaders) -> Iterator[Hit]:
    """Yield the one hit of a package that exports headers and installs none."""
    headers = exported.headers
    package = headers.package
    call = headers.exports[0]
    first = headers.offered[0]
    name = package.facts.name
    if call.name in INCLUDES and not exported.may_be_used:
        message = (
            f"`{call.name}` exports a folder of headers and the package no library: none of its headers (`{first}`) is "
            "installed, so nothing can use them; take the call out"
        )
        edit = remove(package.cmake.file(call.path), call.command)
        fix = Fix("take the export out", (edit,), Safety.UNSAFE)
        yield Hit(call.path, call.command.span, message, Severity.INFO, fix=fix)
        return
    message = (
        f"no header of `include/` (`{first}`) is installed, and `{call.name}` exports them: who uses `{name}` stops at "
        "the first `#include`; add `install(DIRECTORY include/ …)`"
    )
    fix = Fix("install the headers", (install_headers(package.cmake),))
    text, level = by_whom(message, exported.are_needed), None if exported.are_needed else Severity.INFO
    yield Hit(call.path, call.command.span, text, level, fix=fix)


def misplaced(exported: ExportedHeaders) -> Iterator[Hit]:
    """Yield headers that are installed where no user looks for them."""
    headers = exported.headers
    if doubled := exported.in_doubled_folder():
        (word, place), name = doubled, headers.package.facts.name
        message = f"the headers land in `{place}/`: who uses `{name}` stops at the first `#include`"
        level = None if exported.are_needed else Severity.INFO
        text = by_whom(f"{message}; install `include/`, with a slash", exported.are_needed)
        yield Hit(word.path, word.span, text, level)
    elif folder := ExportedIncludeFolders(headers).unexported():
        if not folder.exported and (exported.are_of_plugins or (folder.is_shared and not exported.is_built_against)):
            return
        level = None if exported.are_needed else Severity.INFO
        yield Hit(folder.row.path, folder.row.span, by_whom(not_exported(folder), exported.are_needed), level)
