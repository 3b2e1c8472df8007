"""IDL012 unknown-interface-in-cpp."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...checks.cpp.interfaces_in_cpp import InterfacesInCpp, WrongInterface
from ...checks.fault import WORST_FIRST
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

LINES = """\
find_package(std_msgs REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE ${std_msgs_TARGETS})
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
FILES = {
    "package.xml": manifest("  <depend>std_msgs</depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
}
SOURCE = """\
#include <std_msgs/msg/string.hpp>

int main()
{
  std_msgs::msg::String text;
  return text.data.size();
}
"""


@rule(
    "IDL012",
    "unknown-interface-in-cpp",
    over=InterfacesInCpp,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "in a file that only others compile, tests do, or that is compiled on demand",
        Severity.INFO: "in a file that nothing compiles, though other files are compiled",
    },
    examples=(
        Example(
            bad={**FILES, "src/talker.cpp": SOURCE.replace("std_msgs/msg/string.hpp", "«std_msgs/msg/strng.hpp»")},
            good={"src/talker.cpp": SOURCE},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**FILES, "src/talker.cpp": SOURCE.replace("std_msgs::msg::String", "«std_msgs::msg::Strng»")},
            good={"src/talker.cpp": SOURCE},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_interface_in_cpp(interfaces: InterfacesInCpp) -> Iterator[Hit]:
    """
    ## What it does
    Finds headers and types in C++ of messages, services and actions that their package does not have.
    The header of `SetMode` is `set_mode.hpp`: small letters, with `_` between the words.

    ## Why is this bad?
    The build stops: "No such file or directory", or "is not a member of".

    ## When it is quiet
    Where the package is not in the workspace, unless one of its interfaces has a near name or the header of a package
    of messages has capital letters, or where a list of repositories fetches it; where its interfaces can't be known, or
    it has headers of its own among the generated ones; inside of `#if`, in files that nothing compiles or installs, and
    where the package has a header or a class of that name itself, or its build may make the header: a command writes
    it, or a macro of another package is given that message by its name.

    ## Fix safety
    The intended name is a guess.
    """
    for first, *others in by_interface(interfaces.wrong()):
        edits = tuple(Edit(each.path, each.span, each.meant) for each in (first, *others) if each.meant)
        fix = Fix(f"write `{first.meant}`", edits, Safety.UNSAFE) if first.meant else None
        related = tuple(Related(each.path, each.span, "and here") for each in others)
        yield Hit(first.path, first.span, message(first), Severity(first.level), related, fix)


def by_interface(found: Iterable[WrongInterface]) -> Iterable[list[WrongInterface]]:
    """Return the places of each interface together, those that the build certainly compiles first: one cause."""
    same: dict[tuple[str, str, str], list[WrongInterface]] = {}
    for each in sorted(found, key=lambda each: WORST_FIRST.index(each.level)):
        same.setdefault((each.package, each.kind, each.header_name), []).append(each)
    return same.values()


WHAT = {"msg": "message", "srv": "service", "action": "action"}


def message(each: WrongInterface) -> str:
    if each.is_unlisted:
        what = f"`{each.package}` has the {WHAT[each.kind]} of `{each.text}`, and generates nothing of it"
        return f"{what}: the compiler stops there; list its .{each.kind} file in `rosidl_generate_interfaces`"
    what = f"`{each.package}` has no such {WHAT[each.kind]}"
    near = f" (did you mean `{each.meant}`?)" if each.meant else ""
    advice = "correct the name" if each.meant else "add it, or remove this"
    return f"{what} as `{each.text}`{near}: the compiler stops there; {advice}"
