"""CMK116 redefined-command."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.redefined_commands import RedefinedCommands
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

TELL = """\
function(«message» text)
  message(STATUS "my_pkg: ${text}")
endfunction()
"""


INTENDED = "; nothing here is known to fail by it, which may be intended"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK116",
    "redefined-command",
    over=CMakePackage,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "its body calls the command, and so itself",
        Severity.INFO: "the package does not call it, and it is none that nearly all packages call, or ament's own "
        "takes its place again; or it may be intended: it does something for the package's own calls, or only shows "
        "texts",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(TELL)},
            good={"CMakeLists.txt": cmake(TELL.replace("«message»", "tell"))},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake("function(«find_package» name)\n  message(STATUS ${name})\nendfunction()\n")},
            good={"CMakeLists.txt": cmake("function(find_own name)\n  message(STATUS ${name})\nendfunction()\n")},
            on="ament_cmake",
        ),
    ),
)
def redefined_command(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds functions and macros that are called like a command of CMake or ament.
    Names are compared without regard to case, as CMake does.

    ## Why is this bad?
    From then on every call of this run of CMake runs the function, also those in files that packages install and that
    are found or included here; other packages are built in runs of their own. One whose body calls the command calls
    itself: CMake stops with "Maximum recursion depth of 1000 exceeded".

    ## When it is quiet
    It is an info where the package does not call it and it is no command that the files of nearly all packages call
    (`find_package`, `install`), or calls it and its body does something for that, which may be intended; where only
    texts are lost (`message`), where `find_package()` defines ament's own behind it again, or where its file is
    included under a condition. It is quiet inside of an `if`, which may ask whether the command exists, and where the
    body calls the former command by the name that CMake keeps for it (`_install`). In a copy of the file in which CMake
    or ament defines the command (`GoogleTest.cmake`). Commands of others, such as pybind11, Qt or rosidl, are none of
    these.
    """
    for each in RedefinedCommands(package.cmake).all():
        start = f"`{each.name}` is a command of CMake or ament, and is defined anew here"
        if each.calls_itself:
            message = f"{start}: it calls itself until CMake stops; give it another name"
        else:
            whose = "every later call in the build of this package runs this one, in files that it finds too"
            message = f"{start}: {whose}; give it another name"
        level = Severity.ERROR if each.calls_itself else None
        is_idle = each.may_be_intended and not each.calls_itself
        is_met = each.is_called and not each.lost and not is_idle
        why = each.lost or (INTENDED if is_idle and each.is_called else "")
        yield Hit(each.path, each.span, message + why, level if is_met else Severity.INFO)
