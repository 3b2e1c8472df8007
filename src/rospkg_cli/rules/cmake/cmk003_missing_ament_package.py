"""CMK003 missing-ament-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.commented_installs import said_in
from ...checks.cmake.package_ends import PackageEnds
from ...checks.cmake.unknown_commands import UnknownCommands
from ...checks.manifest.manifest_and_cmake import IDLE
from ...edits.cmake_commands import add_at_end
from ...example import Example
from ...finding import Fix, Hit, Safety, Severity
from ...lazy_regex import regex
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.project_name import PACKAGE_ENDS
from ...rule import rule

GOOD = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)

ament_package()
"""

MACRO = regex(r"(?!ament_|find_|configure_|write_|catkin_|cpm|install|extract_|autoware_package$)\w*package\w*")
"""What may be a macro around ament_package(), such as `my_team_package`; `autoware_package` only looks for packages."""
INSTALLS = regex(r"rosidl_|pluginlib_|rclcpp_components_|ament_python_|ament_index_|ament_auto_|generate_parameter")
"""How commands begin that install or register something."""
CALLED = regex(r"\b(?:autoware_)?ament_(?:auto_)?package\s*\(")
EMPTIED = "all that would build something is commented out: the build is green, and the package is empty"


@rule(
    "CMK003",
    "missing-ament-package",
    over=PackageEnds,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the package is switched off: the call is commented out, with all that would build something",
        Severity.INFO: "targets are built, and nothing is installed or exported: they run where they are built",
    },
    examples=(
        Example(
            bad={
                "CMakeLists.txt": GOOD.replace("\nament_package()\n", "").replace(
                    "project(my_pkg)", "«project(my_pkg)»"
                )
            },
            good={"CMakeLists.txt": GOOD},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def missing_ament_package(ends: PackageEnds) -> Iterator[Hit]:
    """
    ## What it does
    Finds ament_cmake packages whose CMakeLists.txt never calls `ament_package()`.
    `ament_auto_package()` counts as well.

    ## Why is this bad?
    colcon builds them, but nothing registers them: no package.xml in share/, no entry in the resource index, no
    environment. `ros2 run` and `find_package()` don't find the package.

    ## When it is quiet
    Where all that is built is for tests. Where a file that can't be read is included, and where a macro of another
    package whose name has `package` in it is called: both may call `ament_package()`. (`autoware_package()` does not.)
    Where a macro that no file here defines comes behind all that is built, installed and exported, and may be of a
    package that is found: it begins like that (`team_finish` of `team_cmake`), or that package is not known.
    Where its name is misspelt, which CMK114 reports. It is an info where targets are built and nothing is installed,
    exported or registered, as for tests that are run in the build folder. It is a warning where the call is commented
    out, and with it all that would build or install something: the package is switched off on purpose, and is built all
    the same, for those who depend on it.
    """
    package, cmake = ends.package, ends.package.cmake
    if not package.is_ament or not cmake.is_complete or cmake.ends_a_package or cmake.only_tests:
        return
    if cmake.reads_unknown_files or any(MACRO.fullmatch(call.name) for call in cmake.calls):
        return
    if ends.may_be_elsewhere:
        return
    root = cmake.root
    projects = [command for command in root.syntax.commands if command.name == "project"]
    if any(near in PACKAGE_ENDS for _, near in UnknownCommands(cmake).all()):
        return
    place = projects[0].span if projects else root.source.line_span(1)
    if is_switched_off(package):
        advice = "mark it with an empty file `COLCON_IGNORE`, or bring its commands back"
        yield Hit(root.path, place, f"{EMPTIED}; {advice}", Severity.WARNING)
        return
    is_idle, name = has_only_built(package), package.facts.name
    found = f"`ros2 run {name}` and `find_package({name})` don't find the package"
    found = "nothing finds the package, of which nothing is installed either" if is_idle else found
    message = f"CMakeLists.txt never calls `ament_package()`: the build is green, but {found}; call it last"
    knows_ament = any(each.name.startswith("ament_cmake") for each in cmake.packages)
    fix = Fix("call `ament_package()` at the end", (add_at_end(root, "ament_package()"),)) if knows_ament else None
    yield Hit(root.path, place, message, Severity.INFO if is_idle else None, fix=fix)


def is_switched_off(package: CMakePackage) -> bool:
    """Return whether comments call `ament_package()`, and what is no comment builds and installs nothing."""
    cmake = package.cmake
    is_empty = all(call.name in IDLE for call in (*cmake.calls, *cmake.unreachable))
    return is_empty and CALLED.search(said_in(cmake.root)) is not None


def has_only_built(package: CMakePackage) -> bool:
    """Return whether targets are made, and nothing is installed or exported: they are run where they are built."""
    cmake = package.cmake
    passes_on = cmake.installs or any("export" in each.name or INSTALLS.match(each.name) for each in cmake.calls)
    return bool(cmake.targets) and not passes_on and not package.facts.executables
