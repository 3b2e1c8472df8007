"""CMK119 unexported-targets."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.met_here import by_whom
from ...checks.cmake.unexported_libraries import UnexportedLibraries
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

LIBRARY = """\
add_library(core SHARED src/core.cpp)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core EXPORT «core_targets» DESTINATION lib)
"""
EXPORT = "ament_export_targets(core_targets HAS_LIBRARY_TARGET)\n"
OLD = "ament_export_libraries(core)\n"
SOURCE = {"src/core.cpp": "int core() {return 1;}\n", "include/my_pkg/core.hpp": "int core();\n"}
ALONE = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core PUBLIC include)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS «core» DESTINATION lib)
"""
HANDS = "ament_export_include_directories(include)\nament_export_libraries(core)\n"
BOTH = {
    "src/core.cpp": '#include "my_pkg/core.hpp"\n' + SOURCE["src/core.cpp"],
    "include/my_pkg/core.hpp": SOURCE["include/my_pkg/core.hpp"],
}


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK119",
    "unexported-targets",
    over=UnexportedLibraries,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "the package hands its libraries on with `ament_export_libraries()`; or no package here that "
        "looks for it includes its headers"
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(LIBRARY), **SOURCE},
            good={"CMakeLists.txt": cmake(LIBRARY.replace("«", "").replace("»", "") + EXPORT)},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake(LIBRARY + OLD), **SOURCE},
            good={"CMakeLists.txt": cmake(LIBRARY.replace("EXPORT «core_targets» ", "") + OLD)},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake(ALONE), **BOTH},
            good={"CMakeLists.txt": cmake(ALONE.replace("«core»", "core") + HANDS)},
            on="ament_cmake",
        ),
    ),
)
def unexported_targets(unexported: UnexportedLibraries) -> Iterator[Hit]:
    """
    ## What it does
    Finds sets of targets that are installed for other packages and that nothing exports.
    `install(TARGETS … EXPORT set)` fills such a set.
    `ament_export_targets()` exports it, or `install(EXPORT …)`. It finds libraries, too, that are installed along with
    headers which their sources include, where nothing exports any library.

    ## Why is this bad?
    The build is green, and packages that link `my_pkg::library` stop: "the target was not found". It is what is left
    when the line is lost in a merge, or when only the first half was copied.

    ## When it is quiet
    Where any other command is given the name of the set, where a macro of another package or a file that can't be read
    may export it, and for sets of executables, registered classes and components alone, which nothing links. It is an
    info where no package of the workspace looks for this one and includes a header of it: it may be for this package's
    programs alone. It is left alone where a CMake or pkg-config file of the package may tell others of it.
    """
    for found in unexported.sets.all():
        name = found.word.text
        message = f"nothing exports the set `{name}`: packages that link `{found.library}` stop, as it is not found"
        is_met = unexported.is_missed(found)
        text = by_whom(f"{message}; add `ament_export_targets({name})`", is_met)
        yield Hit(found.word.path, found.word.span, text, None if is_met else Severity.INFO)
    if word := unexported.first():
        what = f"`{word.text}` and its headers are installed, and nothing exports the library"
        stops = f"packages that use `{unexported.headers.package.facts.name}` don't link it"
        message = f"{what}: {stops}; add `ament_export_libraries({word.text})`, or `ament_export_targets(…)`"
        level = None if unexported.is_needed else Severity.INFO
        yield Hit(word.path, word.span, by_whom(message, unexported.is_needed), level)
