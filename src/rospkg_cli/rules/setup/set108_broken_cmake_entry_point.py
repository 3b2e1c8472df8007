"""SET108 broken-cmake-entry-point."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.own_imports import OwnImports
from ...checks.setup.cmake_entry_points import CMakeEntryPoints
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.install_table import InstalledFile
from ...rule import rule
from ...suggest import did_you_mean

CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
ament_python_install_package(my_pkg SCRIPTS_DESTINATION lib/my_pkg)
ament_package()
"""
CFG = "[options.entry_points]\nconsole_scripts =\n    {}\n"
FILES = {
    "package.xml": manifest("  <buildtool_depend>ament_cmake_python</buildtool_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE,
    "my_pkg/__init__.py": "",
    "README.md": "Run `ros2 run my_pkg talker`.\n",
    "my_pkg/talker.py": "def main():\n    print('hello')\n",
}


UNSTARTED = "; nothing here starts this program"


@rule(
    "SET108",
    "broken-cmake-entry-point",
    over=CMakeEntryPoints,
    severity=Severity.ERROR,
    levels={Severity.INFO: "where nothing of the repository runs it"},
    examples=(
        Example(
            on="ament_cmake",
            bad={**FILES, "setup.cfg": CFG.format("«talker = my_pkg.taker:main»")},
            good={"setup.cfg": CFG.format("talker = my_pkg.talker:main")},
        ),
        Example(
            on="ament_cmake",
            bad={**FILES, "setup.cfg": CFG.format("«talker = my_pkg.talker:mian»")},
            good={"setup.cfg": CFG.format("talker = my_pkg.talker:main")},
        ),
        Example(
            on="ament_cmake",
            bad={**FILES, "setup.cfg": CFG.format("«talker = 'my_pkg.talker:main'»")},
            good={"setup.cfg": CFG.format("talker = my_pkg.talker:main")},
        ),
    ),
)
def broken_cmake_entry_point(entries: CMakeEntryPoints) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points of a package of CMake whose module or function does not exist.
    `ament_python_install_package(… SCRIPTS_DESTINATION …)` makes executables of those in setup.cfg. Those that are not
    `name = module:function`, with quotes around the value for example, are found without SCRIPTS_DESTINATION too.

    ## Why is this bad?
    The build is green, and `ros2 run` raises ModuleNotFoundError or AttributeError. With one that can't be read the
    build stops, since CMake has setuptools write the package's metadata.

    ## When it is quiet
    Where the installed modules are not all known, for modules of other packages and those that may be compiled or
    generated, and where the module has a `__getattr__` or an unknown star import. SET101 and SET102 tell it of packages
    that setup.py builds. It is an error where a launch file, a page, a script or code of the repository runs the
    program, `ros2 run my_pkg talker` for example, and an info where nothing does.
    """
    imports = entries.imports
    if imports.facts.build_type == "ament_python":
        return
    for entry in entries.refused():
        message = f"`{entry.text}` is no entry point: setuptools stops while CMake runs it, and does not name the place"
        yield Hit(entry.path, entry.span, f"{message}; write `name = module:function`")
    if not imports.table.knows("module"):
        return
    for row in imports.table.of("executable"):
        message = wrong(imports, row) if row.entry else ""
        if message:
            name = row.destination.rpartition("/")[2]
            level = None if entries.is_run(name) else Severity.INFO
            yield Hit(row.path, row.span, f"{message}{UNSTARTED if level else ''}", level)


def wrong(imports: OwnImports, row: InstalledFile) -> str:
    """Return what an executable of an entry point ends with; "" where it may start."""
    module, _, attribute = row.entry.partition(":")
    installed, name = imports.installed, row.destination.rpartition("/")[2]
    start = f"the build is green, and `ros2 run {imports.facts.name} {name}` raises"
    if module.partition(".")[0] not in installed.tops:
        return ""
    if missing := installed.missing(module):
        package, last = missing
        hint = did_you_mean(last, installed.below(package))
        return f"there is no module `{package}.{last}`{hint}: {start} ModuleNotFoundError"
    first = attribute.partition(".")[0]
    if module not in installed.sources or installed.offers(module, first):
        return ""
    return f"`{module}` has no `{first}`{did_you_mean(first, imports.offered(module))}: {start} AttributeError"
