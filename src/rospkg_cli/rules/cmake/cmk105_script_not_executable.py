"""CMK105 script-not-executable."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain

from ...checks.cmake.broken_scripts import BrokenScript, BrokenScripts
from ...checks.cmake.installed_scripts import InstalledScripts
from ...checks.cmake.script_harm import harm, why_mild
from ...checks.cmake.script_sentences import message, title
from ...edits.cmake_scripts import make_executable
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule
from ...source import Span

BARE = "print('hello')\n"
LISTS = "import os\n\nos.system('ros2 topic list')\n"
SHEBANG = "#!/usr/bin/env python3\n"
FILES = "install(FILES «scripts/hello.py» DESTINATION lib/${PROJECT_NAME})\n"
PROGRAMS = FILES.replace("FILES", "PROGRAMS")
FOLDER = "install(DIRECTORY «scripts/» DESTINATION lib/${PROJECT_NAME})\n"
KEPT = "install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME} USE_SOURCE_PERMISSIONS)\n"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK105",
    "script-not-executable",
    over=InstalledScripts,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "only the bit of its source is missing: it can't be run after `colcon build "
        "--symlink-install`; or it is no node, and nothing starts it",
        Severity.INFO: "only its bit is missing, which a copy may have lost, and nothing starts it, or it says that "
        "it is not used, or pages and scripts start it by its path alone; or it has no bit, "
        "and another file of its folder imports it; or it came with its folder or by a pattern, nothing starts it, and "
        "a file imports it, a comment names it, or it has no word of ROS",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(FILES), "scripts/hello.py": SHEBANG + BARE},
            good={"CMakeLists.txt": cmake(PROGRAMS.replace("«", "").replace("»", ""))},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(FOLDER), "scripts/hello.py": SHEBANG + LISTS},
            good={"CMakeLists.txt": cmake(KEPT)},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(PROGRAMS), "scripts/hello.py": BARE},
            good={"scripts/hello.py": SHEBANG + BARE},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def script_not_executable(scripts: InstalledScripts) -> Iterator[Hit]:
    """
    ## What it does
    Finds scripts in `lib/${PROJECT_NAME}` that can't be executed there.
    They are installed with FILES instead of PROGRAMS, with a DIRECTORY that does not keep permissions, without `#!` in
    their first line, or without an executable bit.

    ## Why is this bad?
    `ros2 run` says "No executable found", or the script ends with "Exec format error". PROGRAMS sets the bit on a copy;
    with `colcon build --symlink-install` there is no copy, and the bit of the source counts.

    ## When it is quiet
    For files that another installed script imports, or any Python file by a dotted name (`my_pkg.moves.turn`) where
    they don't start themselves; that hold only definitions, or are launch files; that a launch file passes to
    `python3`, or a macro in a .cmake file of the package to its caller, and that CMake gives to `chmod` by name. For
    what is installed under a condition that can't be evaluated, or for tests. A file without the bit that another
    Python file of its folder imports may be a module: an info, unless a launch file names it or a README starts it.
    What only lacks its bit here is an info where neither does so: archives and some file systems lose it. A file
    without `#!` that has no word of ROS, and a script that is no node (it uses rclpy and asks for `__name__`), are
    warnings there. What a rule takes along with its folder, or by a pattern (`file(GLOB scripts scripts/*.py)`), is an
    info where neither does so and any file of the package imports it, a comment of CMake names it (its line was taken
    out), or it has no word of ROS. So is a script that nothing starts and whose name (`talker_old.py`) or first lines
    (`# no longer used`) say that it is only kept, and one that pages and scripts give to Python by its path alone.
    """
    if not scripts.package.is_ament:
        return
    for script, *others in together(scripts):
        related = tuple(Related(other.copy.source, Span(0, 0), "the same") for other in others)
        operations = [make_executable(scripts, each) for each in (script, *others)]
        fix = Fix(title(script, others), tuple(dict.fromkeys(chain(*operations)))) if all(operations) else None
        text = message(scripts, script, others) + why_mild(scripts, script)
        yield Hit(script.copy.item.path, script.copy.item.span, text, Severity(harm(scripts, script)), related, fix)


def together(scripts: InstalledScripts) -> Iterable[list[BrokenScript]]:
    """Return the scripts of one install() that are broken in the same way and as badly, which is one fault."""
    calls: dict[tuple[str, int, str, str, str], list[BrokenScript]] = {}
    for script in BrokenScripts(scripts).all():
        call = script.copy.rule.call
        place, how = (call.path, call.command.span.start), (harm(scripts, script), why_mild(scripts, script))
        calls.setdefault((*place, script.wrong, *how), []).append(script)
    return calls.values()
