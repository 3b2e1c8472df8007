"""CMK118 unknown-exported-library."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.exported_libraries import ExportedLibraries, WrongExport
from ...checks.cmake.met_here import by_whom
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

LINES = """\
add_library(core SHARED src/core.cpp)
install(TARGETS core
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
ament_export_libraries({})
"""
HEADERS = """\
add_library(headers INTERFACE)
install(TARGETS headers EXPORT export_headers)
ament_export_targets(export_headers)
"""
CORE = "int core() {return 1;}\n"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK118",
    "unknown-exported-library",
    over=ExportedLibraries,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "it has no library, and a package of the workspace is built with this one",
        Severity.INFO: "no package of the workspace looks for this one and, for a name that nothing makes, includes a "
        "header of it; or no library, or one that is exported otherwise, is near to such a name",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(LINES.format("«croe»")), "src/core.cpp": CORE},
            good={"CMakeLists.txt": cmake(LINES.format("core"))},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(HEADERS + "ament_export_libraries(«headers»)\n")},
            good={"CMakeLists.txt": cmake(HEADERS)},
            on="ament_cmake",
        ),
    ),
)
def unknown_exported_library(exported: ExportedLibraries) -> Iterator[Hit]:
    """
    ## What it does
    Finds libraries in `ament_export_libraries()` that cannot be linked.
    They are programs, have no file (INTERFACE and OBJECT libraries), or are nearly called like a library of the
    package; or their names are those of the package or of a library of it, alone or with more words behind it.

    ## Why is this bad?
    The package itself builds. One that calls `find_package()` for it stops with "Package … exports the library … which
    couldn't be found"; for a name that is no target CMake only warns, and the linker misses what is in the library.

    ## When it is quiet
    For other names, which may be libraries of the system, for those that a command of another package is given, and
    where a file that can't be read is included. Under a condition that can't be evaluated. It is an info where no
    package of the workspace looks for this one to be built. A name that nothing makes only warns there: it is more than
    an info where it is a slip of a library of the package which is exported in no other way, and a package of the
    workspace includes a header of this one.

    ## Fix safety
    The nearest library may not be the one that was intended.
    """
    consumers = exported.consumers
    for each in exported.wrong():
        is_unknown = each.kind == "unknown"
        is_needed = bool(consumers.including) and exported.is_lost(each) if is_unknown else bool(consumers.finders)
        fix = None
        if each.near and exported.package.cmake.source_text(each.word).strip('"') == each.word.text:
            fix = Fix(f"write `{each.near}`", (Edit(each.word.path, each.word.span, each.near),), Safety.UNSAFE)
        level = (None if is_unknown else Severity.ERROR) if is_needed else Severity.INFO
        yield Hit(each.word.path, each.word.span, by_whom(message(exported, each), is_needed), level, fix=fix)


def message(exported: ExportedLibraries, each: WrongExport) -> str:
    name = exported.package.cmake.quoted(each.word)
    if each.kind == "unknown":
        near = f" (did you mean `{each.near}`?)" if each.near else ""
        advice = "correct the name" if each.near else "name the library, or remove it"
        return f"nothing makes the library {name}{near}: packages that link this one lack it; {advice}"
    what = "a program" if each.kind == "executable" else "a library without a file"
    advice = "remove it" if each.kind == "executable" else "`ament_export_targets(…)` exports it"
    return (
        f'{name} is {what}: finding this package stops with "exports the library … which couldn\'t be found"; {advice}'
    )
