"""CMK115 unset-variable."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.dead_branches import DeadBranches
from ...checks.cmake.harmless_variables import is_package_used_anyway, keeps_no_flags, why_harmless
from ...checks.cmake.switched_off import SwitchedOff
from ...checks.cmake.unread_lists import UnreadLists
from ...checks.cmake.unread_twins import UnreadTwins
from ...checks.cmake.unset_variable import UnsetVariable
from ...checks.cmake.unset_variables import UnsetVariables
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

LINES = """\
install(DIRECTORY launch
  DESTINATION share/«${PROJECTNAME}»
)
"""
UNMISSED = "; nothing here is shown to miss it"
LONGEST = 60
"""Characters of an argument that a message shows."""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK115",
    "unset-variable",
    over=UnsetVariables,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "it says what is installed, or where",
        Severity.INFO: "another package may set it, as it is more than one letter off, differs in case, or is like one "
        "that a package sets; or it would name targets to install, and no other variable is near; or the command has "
        "the intended one as well, or a target is given a folder or a library by it, and the build fails where that is "
        "needed; or a branch reads it that is not taken, or it is a part of the name that a target has everywhere, or "
        "nothing reads what is set by it, or a list is appended to that nothing reads",
    },
    examples=(
        Example(
            bad={
                "CMakeLists.txt": cmake(LINES),
                "launch/talker.launch.xml": "<launch/>\n",
            },
            good={"CMakeLists.txt": cmake(LINES.replace("«${PROJECTNAME}»", "${PROJECT_NAME}"))},
            on="ament_cmake",
        ),
    ),
)
def unset_variable(variables: UnsetVariables) -> Iterator[Hit]:
    """
    ## What it does
    Finds variables in CMakeLists.txt that nothing sets and that are nearly called like one that is set.
    Near is one or two letters off one of CMake (`PROJECTNAME`) or of the package's own, the same but for capitals, or
    in other letters than the package that is found sets it (`RCLCPP_INCLUDE_DIRS`). In `install(TARGETS)`, as the
    target of `target_link_libraries()` and its like, and as the files of `rosidl_generate_interfaces()` it finds any
    that nothing sets. What a target is given may also lack a word, or have one too many, that a variable has which is
    set and read nowhere. It also finds lists that are appended to, stand nowhere else, and are one or two letters off
    one that is read.

    ## Why is this bad?
    A variable that is not set is empty in CMake, without a word: what should be installed to `share/my_pkg` goes to
    `share/`, and a flag or a folder is lost.

    ## When it is quiet
    Where the name stands anywhere outside of `${…}`, since a command may set it, and where it begins like what
    `cmake_parse_arguments()` sets; those like the package's own where they begin like a package that is found, or where
    a macro of another one is called; where `find_library()` and its like look for something below them, or the file
    reads `$ENV{…}` of the same name: the user gives them. In `message()`. Under an unknown condition only names near to
    those of CMake are reported, as warnings; where a file is included that can't be read, those near to PROJECT_NAME in
    `install()`, and those near a variable that nothing reads, as infos. A name is an info, too, that is more than one
    letter off, differs in case alone, or is like one that a package sets, and one like the package's own where a
    package is found that is not known, or that has nothing but CMake files for others. So it is where the right one
    stands in the same command, as nothing is lost; where targets get a folder or a library by it, for the build fails
    where they need it; where flags are kept that nothing sets before; and what is read where a package is found
    (`if(OpenMP_FOUND)`) that nothing looks for, a part of the name of a target that is called so everywhere, and
    the value of what nothing reads. What packages set that are not built with ament (`octomap`) is known of none.
    """
    dead, off = DeadBranches(variables.cmake), SwitchedOff(variables.cmake)
    for each in (*variables.all(), *UnreadTwins(variables).all()):
        is_sure = each.call.name == "install" and not each.call.maybe
        is_mild = (
            (not each.near and each.call.name == "install") or bool(dead.package_of(each.call)) or off.has(each.call)
        )
        is_mild = is_mild or bool(each.given_anyway) or each.is_shown_by_build
        why = why_harmless(variables.cmake, each)
        is_mild = is_mild or is_package_used_anyway(variables.cmake, each) or keeps_no_flags(variables.cmake, each)
        is_certain = variables.is_certain(each)
        level = Severity.INFO if is_mild or why or not is_certain else Severity.ERROR if is_sure else None
        text = message(each, is_certain or is_mild) + why
        yield Hit(each.call.path, each.span, text, level)
    for lost in UnreadLists(variables.cmake).all():
        text = f"nothing reads `{lost.name}` (did you mean `{lost.near}`?): what is appended is lost; correct the name"
        yield Hit(lost.path, lost.span, text + UNMISSED, Severity.INFO)


def message(each: UnsetVariable, is_certain: bool) -> str:
    empty = "it is empty" if is_certain else "it is empty, unless another package sets it"
    if not each.near and each.call.name != "install":
        return f"`{each.name}` is set nowhere: {empty}, and `{each.call.name}` stops CMake; set it, or remove the call"
    if not each.near:
        return f"`{each.name}` is set nowhere: it is empty, and no target is installed by it; set it, or remove it"
    if each.given_anyway:
        return f"`{each.name}` is set nowhere: it is empty, and `{each.given_anyway}` stands next to it; remove it"
    shown = len(each.before) <= LONGEST and "\n" not in each.before
    result = f"`{each.after}`" if each.after else "nothing"
    becomes = f", and `{each.before}` becomes {result}" if shown else ""
    return f"`{each.name}` is set nowhere (did you mean `{each.near}`?): {empty}{becomes}; correct the name"
