"""CMK104 wrong-executable-destination."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.doubled_folders import misplaced_folders
from ...checks.cmake.misplaced_executables import MisplacedExecutables
from ...checks.cmake.misplaced_modules import MisplacedModules
from ...edits.misplaced_together import OF_FILES, level, together
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.cmake.empty_destinations import empty_destination
from ...rule import rule

MAIN = "int main() {return 0;}\n"
README = "Start it with `ros2 run my_pkg talker`.\n"
WRONG = "add_executable(talker src/talker.cpp)\ninstall(TARGETS «talker» DESTINATION share/${PROJECT_NAME})\n"
BOTH = """\
add_library(core SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
install(TARGETS
  core
  «talker»
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
"""
SPLIT = """\

install(TARGETS talker
  DESTINATION lib/${PROJECT_NAME}
)
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK104",
    "wrong-executable-destination",
    over=MisplacedExecutables,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "neither a launch file nor the README starts the node, and it goes to bin/, or is a script",
        Severity.INFO: "nothing shows that it is a node, it lies in bin/ on purpose or is a test or demonstration "
        "next to others, a script is installed as another file, any file next to the packages' folders in lib/ or "
        "share/, or a folder in one of its own name",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(WRONG), "src/talker.cpp": MAIN, "README.md": README},
            good={"CMakeLists.txt": cmake(WRONG.replace("«talker»", "talker").replace("share/", "lib/"))},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={
                "CMakeLists.txt": cmake(BOTH),
                "src/talker.cpp": MAIN,
                "src/core.cpp": "int core() {return 1;}\n",
                "README.md": README,
            },
            good={"CMakeLists.txt": cmake(BOTH.replace("  «talker»\n", "") + SPLIT)},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def wrong_executable_destination(misplaced: MisplacedExecutables) -> Iterator[Hit]:
    """
    ## What it does
    Finds executables and scripts that are not installed to `lib/${PROJECT_NAME}`.
    A tool that is no node may lie elsewhere on purpose, and a node may be in bin/ if it is in both. Executable nodes in
    Python count too where a rule for files or folders installs them into bin/ or share/, and all files that land in
    `share` itself, scripts of a folder that lands in `lib` itself, and folders that land in one of their own name. So
    do modules of Python that CMake builds (`pybind11_add_module()`), where no interpreter looks.

    ## Why is this bad?
    `ros2 run` and launch files look in `lib/<package>` alone: "No executable found".

    ## When it is quiet
    Where another rule installs it into `lib/<package>` too, under a condition that can't be evaluated, and for what
    tests put into bin/, or a page or script of the package starts by its path (`…/bin/talker`), a launch file or a test
    by its folder (`examples/talker`). For scripts that neither use rclpy nor are started by name, and for those that a
    launch file runs by their path, or pages and scripts alone (`python3 …/talker.py`). In a folder whose CMakeLists.txt
    names a project of its own, where `lib/${PROJECT_NAME}` is intended, and where a rule runs code, which may link it
    there. In bin/, which is on the PATH, an info is what runs no node (no `rclcpp::init`, no `Node`), as a tool for
    bags, or lies next to others that go to `lib/<package>`.

    ## Fix safety
    What is in bin/, and is started by no launch file and no README, may be called by its name: moving it is not safe.
    """
    name = misplaced.package.facts.name
    if not misplaced.package.is_ament:
        return
    project = misplaced.package.cmake.project_name
    wrong = (each for each in misplaced.all() if project == name or each.destination != f"lib/{project}")
    for edits, (first, *others) in together(misplaced.package.cmake, wrong):  # CMK001 reports the project's name
        count = f" and {len(others)} more" if others else ""
        start = f"`{first.name}`{count} {'are' if others else 'is'} installed into `{first.destination}`"
        lacks = ", as `DESTINATION` has no value" if empty_destination(first.rule) else ""
        place = "lib/${PROJECT_NAME}"
        todo = f"install them as PROGRAMS into `{place}`" if first.rule.kind in OF_FILES else f"use `{place}`"
        message = f"{start}{lacks}: `ros2 run {name} {first.name}` and launch files look in `lib/{name}` alone; {todo}"
        severity = level(first)
        safety = Safety.SAFE if severity is None else Safety.UNSAFE
        fix = Fix(f"install `{first.name}`{count} into lib/${{PROJECT_NAME}}", edits, safety) if edits else None
        places = dict.fromkeys((each.word.path, each.word.span) for each in others if each.word != first.word)
        related = tuple(Related(path, span, "and here") for path, span in places)
        yield Hit(first.word.path, first.word.span, message, severity, related, fix)
    for word, sentence in misplaced_folders(misplaced.package):
        yield Hit(word.path, word.span, sentence, Severity.INFO)
    for module in MisplacedModules(misplaced.package).all():
        severity = Severity.WARNING if module.is_imported else Severity.INFO
        yield Hit(module.word.path, module.word.span, module.sentence, severity)
