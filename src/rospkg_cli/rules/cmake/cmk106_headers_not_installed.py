"""CMK106 headers-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.exported_headers import ExportedHeaders
from ...checks.cmake.told_folders import ToldFolders, UntoldFolder
from ...checks.enumeration import in_ticks
from ...edits.cmake_commands import remove
from ...edits.cmake_install import install_headers
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...package.cmake.installed_headers import INCLUDES
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
INSTALL = """\

install(DIRECTORY include/
  DESTINATION include/${PROJECT_NAME}
)
"""
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
    levels={Severity.INFO: "no library is exported, or one of plugins or components, and no package here builds on it"},
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
    include)`, which makes a folder in the folder, and headers in `include/my_pkg/` where users are told of `include`
    alone (`$<INSTALL_INTERFACE:…>`, INCLUDES DESTINATION, `ament_export_include_directories()`).

    ## Why is this bad?
    This package builds. Another one that links the library stops with "No such file or directory" at the first
    `#include`. Where no library is exported, there is nothing to link either: then take the export out.

    ## When it is quiet
    Where an install rule or CMake itself can't be evaluated, in `ament_auto_package()`, for a plugin that exports only
    targets, and as soon as one header is installed. Plugins and components are loaded and not linked: an info, where no
    package of the workspace builds against this one; so are headers in a folder that no user is told of.
    """
    headers = exported.headers
    package = headers.package
    yield from misplaced(exported) if package.is_ament else ()
    if not package.is_ament or not headers.are_uninstalled():
        return
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
    level = Severity.INFO if exported.are_of_plugins else None
    yield Hit(call.path, call.command.span, message, level, fix=fix)


def misplaced(exported: ExportedHeaders) -> Iterator[Hit]:
    """Yield headers that are installed where no user looks for them."""
    headers = exported.headers
    if doubled := exported.in_doubled_folder():
        word, place = doubled
        name = headers.package.facts.name
        message = f"the headers land in `{place}/`: who uses `{name}` stops at the first `#include`"
        is_quiet = exported.are_of_plugins or not exported.may_be_used or not headers.exports
        level = Severity.INFO if is_quiet and not exported.is_built_against else None
        yield Hit(word.path, word.span, f"{message}; install `include/`, with a slash", level)
    elif untold := ToldFolders(headers).untold():
        level = Severity.INFO if exported.are_of_plugins or not exported.is_built_against else None
        yield Hit(untold.row.path, untold.row.span, not_told(untold), level)


def not_told(each: UntoldFolder) -> str:
    told = f"users are told of {in_ticks(each.told)} alone" if each.told else "no command tells users of it"
    stops = f"`#include <{each.header}>` stops in packages that use this one"
    wanted = f"write `$<INSTALL_INTERFACE:{each.folder}>`" if each.is_told_by_target else f"export `{each.folder}`"
    return f"the headers land in `{each.folder}/`, and {told}: {stops}; {wanted}"
