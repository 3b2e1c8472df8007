"""CMK102 missing-installed-path."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from posixpath import basename

from ...checks.cmake.brought_paths import BroughtPaths
from ...checks.cmake.built_for_ros1 import is_built_for_ros1
from ...checks.cmake.missing_path_sentences import PLURAL, consequence
from ...checks.cmake.missing_paths import MissingPaths
from ...checks.enumeration import in_ticks
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.cmake.intended_paths import intended_path
from ...package.cmake.referenced_paths import ReferencedPath, ReferencedPaths
from ...rule import rule

MAX_RELATED = 3
INSTALL = CMAKE.replace(
    "ament_package", "install(DIRECTORY meshes «rviz»\n  DESTINATION share/${PROJECT_NAME}\n)\nament_package"
)
SOURCE = CMAKE.replace(
    "ament_package",
    "add_executable(talker «src/talkr.cpp»)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package",
)
TEST = CMAKE.replace(
    "ament_package",
    "if(BUILD_TESTING)\n  find_package(ament_cmake_pytest REQUIRED)\n"
    "  ament_add_pytest_test(test_hello «test/test_helo.py»)\nendif()\n\nament_package",
)
EXTRAS = CMAKE.replace("ament_package()", "ament_package(CONFIG_EXTRAS «cmake/my_pkg_extras.cmake»)")


@rule(
    "CMK102",
    "missing-installed-path",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is named in a branch that is taken only for some; or CMake runs a program in the "
        "package's folder, which may write what is installed",
        Severity.INFO: "FILES_MATCHING keeps CMake silent about the folder, git ignores a folder that people fill, a "
        "script makes it, a page has people make, copy or clone it, or all sources are of ROS 1, or it is named for "
        "another system than Linux",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": INSTALL, "meshes/base.stl": "solid base\n"},
            good={"CMakeLists.txt": INSTALL.replace("«rviz»", "").replace("meshes \n", "meshes\n")},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": SOURCE, "src/talker.cpp": "int main() {return 0;}\n"},
            good={"CMakeLists.txt": SOURCE.replace("«src/talkr.cpp»", "src/talker.cpp")},
            on="ament_cmake",
        ),
        Example(
            bad={
                "CMakeLists.txt": TEST,
                "package.xml": manifest("  <test_depend>ament_cmake_pytest</test_depend>\n", "ament_cmake"),
                "test/test_hello.py": "def test_hello(): pass\n",
            },
            good={"CMakeLists.txt": TEST.replace("«test/test_helo.py»", "test/test_hello.py")},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": EXTRAS, "cmake/my_pkg-extras.cmake": "set(MY_PKG_WORD hello)\n"},
            good={"CMakeLists.txt": EXTRAS.replace("«cmake/my_pkg_extras.cmake»", "cmake/my_pkg-extras.cmake")},
            on="ament_cmake",
        ),
    ),
)
def missing_installed_path(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds files and folders that CMake reads, installs or compiles and that do not exist.
    It reads `install()`, `add_executable()` and `add_library()`, tests (`ament_add_gtest()`, `ament_add_pytest_test()`,
    `add_launch_test()` and the like), the YAML of `generate_parameter_library()`, what `add_subdirectory()` and
    `include()` read, and the CONFIG_EXTRAS of `ament_package()`. What CMake or the build writes itself is left alone.

    ## Why is this bad?
    CMake stops: at once for a missing source, and only after everything was compiled for a missing folder ("file
    INSTALL cannot find …"). It is what is left when a file was renamed, or when git did not keep an empty folder.

    ## When it is quiet
    Where something makes the path: `configure_file()`, `file(DOWNLOAD …)`, an OUTPUT or BYPRODUCTS, a program that is
    run in its folder or is given it, a generator of sources. Where a .gitignore names it, since a build then writes it;
    an installed folder whose files people write, such as `launch`, is an info. Below a submodule that is not checked
    out. Inside `if(EXISTS …)`, for what is installed inside any condition that can't be evaluated, and with OPTIONAL. A
    folder with FILES_MATCHING stops nothing: an info, or a warning where another one is called nearly so. Where CMake
    chooses between ament and catkin and all sources are of ROS 1, it is an info; so is what is named inside `if(WIN32)`
    or the like, for another processor (`aarch64`), and inside a branch that asks for a switch which is off: an option
    without `ON`, a variable that nothing sets, and that no page or script of the repository has, or one that is never
    true (`if(0)`, after `set(WITH_ARM OFF)`). So is what a script makes (`mkdir -p generated`, `-o a.urdf`), a folder
    that a page has people make or fill for maps, data or the like, a file that one has them copy, also with the whole
    folder into a package of `ros2 pkg create`, and what lies in a repository that they clone (`git clone …
    third_party/sdk`) or that a `.repos` file lists.
    """
    missing = MissingPaths(package.cmake)
    names = frozenset({package.facts.name, basename(package.facts.folder)} - {""})
    left = BroughtPaths(package.cmake.package_files, names)
    for (named, for_everyone), *others in together(package.cmake, missing.all()):
        paths = list(dict.fromkeys([named.path, *(each.path for each, _ in others)]))
        near = f" (did you mean `{intended}`?)" if (intended := intended_path(package.cmake, named)) else ""
        do, end = ("do", PLURAL.get(named.use, consequence(named))) if paths[1:] else ("does", consequence(named))
        message = f"{in_ticks(paths)} {do} not exist{near}: {end}"
        related = tuple(Related(each.word.path, each.word.span, "and here") for each, _ in others[:MAX_RELATED])
        level = None if for_everyone else Severity.WARNING
        if named.use == "matching":
            level = Severity.WARNING if near else Severity.INFO
        is_idle = is_built_for_ros1(package.cmake) or missing.is_idle(named)
        level = Severity.INFO if is_idle else level
        if level is not Severity.INFO and (why := left.why_left(named.use, paths)):
            fault, between, advice = message.rpartition("; ")
            level, message = Severity.INFO, f"{fault}, {why}{between}{advice}"
        yield Hit(named.word.path, named.word.span, message, level, related=related)
    for each in ReferencedPaths(package.cmake).ignored():
        start = f"`{each.path}` does not exist, and git ignores it: on a fresh clone the build stops at the end"
        message = f"{start}, as it can't be installed; take it out of .gitignore, or write OPTIONAL"
        yield Hit(each.word.path, each.word.span, message, Severity.INFO)


def together(cmake: CMake, found: Iterable[tuple[ReferencedPath, bool]]) -> Iterable[list[tuple[ReferencedPath, bool]]]:
    """Return what is missing by path and consequence, in the order of the first ones: one file is one cause.

    So are folders of one `install()`, of which none is nearly called like another one.
    """
    same: dict[object, list[tuple[ReferencedPath, bool]]] = {}
    for named, for_everyone in found:
        kind = (consequence(named), for_everyone)
        is_one = named.use == "folder" and not intended_path(cmake, named)
        of_call = same.get((id(named.call.command), *kind)) if is_one else None
        group = same.setdefault((named.path, *kind), [] if of_call is None else of_call)
        group.append((named, for_everyone))
        if is_one:
            same.setdefault((id(named.call.command), *kind), group)
    return list({id(group): group for group in same.values()}.values())
