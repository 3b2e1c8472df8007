"""CMK106 headers-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.cmake_install import install_headers
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...package.cmake.installed_headers import INCLUDES, PublicHeaders
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
    over=PublicHeaders,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={**FILES, "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package")},
            good={"CMakeLists.txt": CMAKE.replace("ament_package", GOOD + "ament_package")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def headers_not_installed(headers: PublicHeaders) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages that export a library or include directories and install no headers.
    Only packages that have headers in `include/` are checked.

    ## Why is this bad?
    This package builds. Another one that links the library stops with "No such file or directory" at the first
    `#include`.
    """
    package = headers.package
    if not package.is_ament or not headers.are_uninstalled():
        return
    call = headers.exports[0]
    first = headers.offered[0]
    if call.name in INCLUDES:
        start = f"`{call.name}` exports a folder of headers, and none of those in `include/` (`{first}`) is installed:"
        message = (
            f"{start} `find_package({package.facts.name})` warns that the folder does not exist, and including one "
            "stops; add `install(DIRECTORY include/ …)`, or export nothing"
        )
    else:
        start = f"`{call.name}` exports what needs the headers in `include/` (`{first}`), and none of them is installed"
        message = f"{start}: linking it stops at the first `#include`; add `install(DIRECTORY include/ …)`"
    fix = Fix("install the headers", (install_headers(package.cmake),))
    yield Hit(call.path, call.command.span, message, fix=fix)
