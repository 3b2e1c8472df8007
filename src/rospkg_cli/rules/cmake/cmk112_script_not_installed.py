"""CMK112 script-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.idle_scripts import IdleScripts
from ...checks.cmake.installed_scripts import InstalledScripts
from ...checks.cmake.unlisted_scripts import UnlistedScripts
from ...checks.enumeration import in_ticks
from ...edits.cmake_install import install_script
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...package.cmake.project_name import PACKAGE_ENDS
from ...rule import rule

SHOWN = 4
"""Programs that a message names."""
SCRIPT = "#!/usr/bin/env python3\nprint('hello')\n"
README = "Say goodbye with `ros2 run my_pkg bye.py`.\n"
ONE = CMAKE.replace(
    "ament_package",
    "install(PROGRAMS\n  «scripts/hello.py»\n  DESTINATION lib/${PROJECT_NAME}\n)\nament_package",
)


@rule(
    "CMK112",
    "script-not-installed",
    over=InstalledScripts,
    severity=Severity.WARNING,
    levels={Severity.INFO: "no launch file names it, and no README starts it with `ros2 run`"},
    examples=(
        Example(
            bad={"CMakeLists.txt": ONE, "scripts/hello.py": SCRIPT, "scripts/bye.py": SCRIPT, "README.md": README},
            good={"CMakeLists.txt": ONE.replace("«scripts/hello.py»", "scripts/hello.py\n  scripts/bye.py")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def script_not_installed(scripts: InstalledScripts) -> Iterator[Hit]:
    """
    ## What it does
    Finds executable scripts that are not installed although scripts in the same folder are.
    The others are installed with `install(PROGRAMS)`. It finds `scripts/` and the like, too, of which nothing is
    installed though a program in it is a node, or one that the README names; it may lack a suffix.

    ## Why is this bad?
    The build is green, and `ros2 run` finds the one and not the other.

    ## When it is quiet
    Where install rules can't be evaluated, where another command names the script, for scripts of tests, and for those
    whose names begin with `_`. Where no launch file names it, and no README or script starts it with `ros2 run`, it may
    be for developers: an info; a shell script is then left alone.
    """
    if not scripts.package.is_ament:
        return
    for path, neighbour in UnlistedScripts(scripts).all():
        message = (
            f"`{path}` is not installed, but `{neighbour.source}` is: `ros2 run {scripts.package.facts.name} "
            f"{path.rpartition('/')[2]}` does not find it; add it to `install(PROGRAMS …)`"
        )
        level = None if scripts.starts.is_wanted(path) else Severity.INFO
        fix = only_plain_names(Fix(f"install `{path}`", (install_script(scripts.package.cmake, path),)), path)
        yield Hit(neighbour.item.path, neighbour.item.span, message, level, fix=fix)
    if idle := IdleScripts(scripts).first():
        call = [each for each in scripts.package.cmake.calls if each.name.endswith(PACKAGE_ENDS)][-1]
        yield Hit(call.path, call.command.span, not_run(scripts.package.facts.name, idle), Severity.INFO)


def not_run(name: str, programs: tuple[str, ...]) -> str:
    some = in_ticks(path.rpartition("/")[2] for path in programs[:SHOWN]) + (" and others" if programs[SHOWN:] else "")
    start = f"nothing of `{programs[0].partition('/')[0]}/` is installed ({some})"
    return f"{start}: `ros2 run {name} …` does not find it; add `install(PROGRAMS … DESTINATION lib/${{PROJECT_NAME}})`"
