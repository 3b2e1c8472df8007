"""CMK103 target-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.doubled_names import DoubledNames
from ...checks.cmake.misplaced_libraries import MisplacedLibraries
from ...checks.cmake.node_programs import NodePrograms
from ...checks.cmake.side_programs import is_side_program
from ...checks.cmake.target_references import TargetReferences
from ...checks.cmake.uninstalled_sentences import said_twice, uninstalled
from ...checks.cpp.dropped_links import DroppedLinks
from ...checks.cpp.idle_programs import is_idle_program
from ...edits.cmake_install import install_executable, install_library
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.uninstalled_target import UninstalledTarget
from ...package.cmake.uninstalled_targets import UninstalledTargets
from ...rule import rule
from ...suggest import near_names

MAIN, README = "int main() {return 0;}\n", "Run `ros2 run my_pkg listener` next to it.\n"
TWO = """\
add_executable(talker src/talker.cpp)
add_executable(«listener» src/listener.cpp)
install(TARGETS talker
  DESTINATION lib/${PROJECT_NAME}
)
"""
BOTH = TWO.replace("«listener»", "listener").replace("TARGETS talker", "TARGETS talker listener")
USE = '#include "core.hpp"\n'
CORE = {"src/talker.cpp": USE + MAIN, "src/core.cpp": USE, "src/core.hpp": "int core();\n"}
LIBRARY = """\
add_library(«core» SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE core)
install(TARGETS talker
  DESTINATION lib/${PROJECT_NAME}
)
"""
CORE_INSTALLED = """\

install(TARGETS core
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK103",
    "target-not-installed",
    over=DroppedLinks,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "an exported target needs it: CMake stops",
        Severity.INFO: "an executable is no node: its sources leave ROS alone, and nothing starts it by `ros2 run`; or "
        "a comment has its `install()`, a page starts it where it is built, or it is a test or demonstration by its "
        "name or folder next to programs that are installed; or it is not certain that a program needs a library, or "
        "no package here looks for this one, which exports it; or a source of ROS 1 ends its build",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(TWO), "src/talker.cpp": MAIN, "src/listener.cpp": MAIN, "README.md": README},
            good={"CMakeLists.txt": cmake(BOTH)},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(LIBRARY), **CORE},
            good={"CMakeLists.txt": cmake(LIBRARY.replace("«core»", "core") + CORE_INSTALLED)},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def target_not_installed(dropped: DroppedLinks) -> Iterator[Hit]:
    """
    ## What it does
    Finds executables, and shared libraries needed at run time, that are built and not installed.
    It also finds libraries that are installed into another folder than `lib`, and libraries that are left out where the
    name of the one before stands twice. A component, another installed target, or users need a shared library.

    ## Why is this bad?
    The build is green. `ros2 run` finds no such executable; a program ends with "error while loading shared libraries",
    also where the library is in `lib/<package>`, unless a RPATH or `--symlink-install` helps. A target that an exported
    one is linked with has to be exported too: CMake stops.

    ## When it is quiet
    Where an install rule can't be evaluated or runs code, and where the build puts its files into an installed folder
    (`CMAKE_RUNTIME_OUTPUT_DIRECTORY`). For executables that a test or another command uses, and in folders of tests,
    examples or third parties. For static libraries, with EXCLUDE_FROM_ALL, and where the RPATH of what is installed
    names the build folder. A library is an info where what is linked with it does not surely include a header of it
    with a function, or compiles a source of it itself (`#include "core.cpp"`): the linker leaves it out
    (`--as-needed`); and one in another folder where that is a MODULE, or lies next to it: a host loads these. So are
    one that is only exported, where no package here looks for this one, targets that stop at ROS 1, and `./talker`.
    """
    package = dropped.package
    if not package.is_ament:
        return
    misspelt = {each.word.text for each in TargetReferences(package.cmake).broken() if each.call.name == "install"}
    programs, reported = NodePrograms(package), set()
    for forgotten in UninstalledTargets(package.cmake).all():
        word = forgotten.target.word
        if near_names(word.text, misspelt):
            continue  # the install rule that means it is CMK110's
        fix = only_plain_names(Fix(f"install `{word.text}`", (edit(package, forgotten),)), word.text)
        reported.add(word.text)
        why_idle, unmet = dropped.why_idle(forgotten), dropped.why_unmet(forgotten)
        text, worth = uninstalled(package, forgotten, why_idle=why_idle), level(forgotten, programs, dropped)
        yield Hit(word.path, word.span, text + unmet, Severity.INFO if why_idle or unmet else worth, fix=fix)
    for each in DoubledNames(package.cmake).all():
        if each.target.name not in reported:
            related = (Related(each.first.path, each.first.span, "it stands here first"),)
            yield Hit(each.word.path, each.word.span, said_twice(each), related=related)
    for misplaced in MisplacedLibraries(package.cmake).all():
        why, word = dropped.why_misplaced(misplaced), misplaced.word
        text = misplaced.idle_sentence(why) if why else misplaced.sentence
        yield Hit(word.path, word.span, text, Severity.INFO if why else None)


def level(forgotten: UninstalledTarget, programs: NodePrograms, dropped: DroppedLinks) -> Severity | None:
    if is_idle_program(programs, forgotten.target) or is_side_program(programs, forgotten.target, dropped.workspace):
        return Severity.INFO
    return Severity.ERROR if forgotten.stops else None


def edit(package: CMakePackage, forgotten: UninstalledTarget) -> Edit:
    if forgotten.target.is_executable:
        return install_executable(package.cmake, forgotten.target)
    exports = (rule.export.text for rule in package.cmake.installs if rule.export is not None and forgotten.stops)
    return install_library(package.cmake, forgotten.target, next(exports, ""))
