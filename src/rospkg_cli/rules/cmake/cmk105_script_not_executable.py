"""CMK105 script-not-executable."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from ...checks.cmake.installed_scripts import BrokenScript, InstalledScripts
from ...checks.enumeration import in_ticks
from ...edits.cmake_scripts import make_executable
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule
from ...source import Span

FEW = 3
"""So many scripts are named one by one."""
BARE = "print('hello')\n"
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
        Severity.WARNING: "only its executable bit is missing: it can't be run after `colcon build --symlink-install`"
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(FILES), "scripts/hello.py": SHEBANG + BARE},
            good={"CMakeLists.txt": cmake(PROGRAMS.replace("«", "").replace("»", ""))},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(FOLDER), "scripts/hello.py": SHEBANG + BARE},
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
    they don't start themselves; that hold only definitions, or are launch files; that a launch file hands to `python3`,
    or a macro in a .cmake file of the package to whom it calls, and that CMake gives to `chmod` by name. For what is
    installed under a condition that can't be evaluated, or for tests.
    """
    if not scripts.package.is_ament:
        return
    for script, *others in together(scripts.broken()):
        mild = script.wrong == "no bit" or (script.wrong == "directory" and scripts.uses_programs)
        level = Severity.WARNING if mild else None
        related = tuple(Related(other.copy.source, Span(0, 0), "the same") for other in others)
        operations = [make_executable(scripts, each) for each in (script, *others)]
        fix = Fix(title(script, others), tuple(dict.fromkeys(chain(*operations)))) if all(operations) else None
        yield Hit(script.copy.item.path, script.copy.item.span, message(scripts, script, others), level, related, fix)


def together(broken: Iterable[BrokenScript]) -> Iterable[list[BrokenScript]]:
    """Return the scripts of one install() that are broken in the same way, which is one fault."""
    calls: dict[tuple[str, int, str], list[BrokenScript]] = {}
    for script in broken:
        call = script.copy.rule.call
        calls.setdefault((call.path, call.command.span.start, script.wrong), []).append(script)
    return calls.values()


def title(script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    these = named(script, others)
    match script.wrong:
        case "files":
            return "install with PROGRAMS"
        case "no shebang":
            return f"begin {these} with `{SHEBANG.strip()}`"
        case "directory":
            return "add USE_SOURCE_PERMISSIONS"
        case _:
            return f"make {these} executable"


def named(script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    """Return the scripts by name, where they are few."""
    if len(others) < FEW:
        return in_ticks(each.copy.source for each in (script, *others))
    return f"`{script.copy.source}` and {len(others)} more"


def message(scripts: InstalledScripts, script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    path, name = script.copy.source, script.copy.destination.rpartition("/")[2]
    run = f"`ros2 run {scripts.package.facts.name} {name}`"
    these, are, them = named(script, others), "are" if others else "is", "them" if others else "it"
    chmod = "`chmod +x` them" if others else f"`chmod +x {path}`"
    match script.wrong:
        case "files":
            return (
                f"{these} {are} installed with FILES, which makes {them} not executable: {run} does not find it; "
                "use PROGRAMS"
            )
        case "no shebang":
            begin = "do not begin" if others else "does not begin"
            return f'{these} {begin} with `#!`: {run} ends with "Exec format error"; write `{SHEBANG.strip()}`'
        case "directory":
            return f"the executable bit of {these} is not installed: {run} does not find it; add USE_SOURCE_PERMISSIONS"
        case "directory, no bit":
            return f"{these} {are} not executable: {run} does not find it; {chmod}"
        case _:
            return (
                f"{these} {are} not executable: after `colcon build --symlink-install` {run} does not find it; {chmod}"
            )
