"""IDL013 unknown-field-in-cpp."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cpp.fields_in_cpp import FieldsInCpp, WrongField
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
VALUE = """\
#include <std_msgs/msg/string.hpp>

int main()
{
  std_msgs::msg::String text;
  return text.data.size();
}
"""
POINTER = """\
#include <std_msgs/msg/header.hpp>

int hear(const std_msgs::msg::Header::SharedPtr header)
{
  return header->stamp.sec;
}

int main()
{
  return 0;
}
"""


@rule(
    "IDL013",
    "unknown-field-in-cpp",
    over=FieldsInCpp,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "in a file that only others compile, tests do, or that is compiled on demand",
        Severity.INFO: "in a file that nothing compiles, though other files are compiled",
    },
    examples=(
        Example(
            bad={**FILES, "src/talker.cpp": VALUE.replace("text.data", "text.«daat»")},
            good={"src/talker.cpp": VALUE},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**FILES, "src/talker.cpp": POINTER.replace("stamp.sec", "stamp.«secs»")},
            good={"src/talker.cpp": POINTER},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_field_in_cpp(fields: FieldsInCpp) -> Iterator[Hit]:
    """
    ## What it does
    Finds fields that C++ sets or reads and that the message does not have.
    The message of a variable is known by its declaration (`std_msgs::msg::String text`, `…::SharedPtr msg`,
    `auto text = std_msgs::msg::String()`, `std::make_shared<…>()`), and the messages that its fields hold are followed.

    ## Why is this bad?
    The build stops: "has no member named".

    ## When it is quiet
    Where a file declares the same name with another type as well, outside of the block of the declaration, for calls,
    inside of `#if`, and in files that nothing compiles or installs. For packages outside of the workspace, unless the
    name is near a field or was one in ROS 1 and no list of repositories fetches another version.

    ## Fix safety
    The intended field is a guess.
    """
    groups: dict[tuple[str, str, str], list[WrongField]] = {}
    for each in fields.wrong():
        groups.setdefault((each.path, each.message, each.name), []).append(each)
    for first, *others in groups.values():
        edits = tuple(Edit(each.path, each.span, each.near) for each in (first, *others) if each.near)
        fix = Fix(f"write `{first.near}`", edits, Safety.UNSAFE) if edits else None
        hint = f" (did you mean `{first.near}`?)" if first.near else ""
        related = tuple(Related(each.path, each.span, "and here") for each in others)
        message = f"`{first.message}` has no field `{first.name}`{hint}: the compiler stops there; correct it"
        yield Hit(first.path, first.span, message, Severity(first.level), related, fix)
