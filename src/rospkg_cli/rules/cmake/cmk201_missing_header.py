"""CMK201 missing-header."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...checks.cpp.foreign_headers import ForeignHeader, ForeignHeaders
from ...checks.cpp.missing_headers import MissingHeader, MissingHeaders
from ...checks.cpp.unreached_headers import UnreachedHeader, UnreachedHeaders
from ...checks.depends.ros1_sources import Ros1Use
from ...checks.fault import WORST_FIRST
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

LINES = """\
add_executable(talker src/talker.cpp)
target_include_directories(talker PRIVATE include)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
SOURCE = """\
#include "my_pkg/words.hpp"

int main()
{
  return words();
}
"""


@rule(
    "CMK201",
    "missing-header",
    over=MissingHeaders,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "in a file that only others compile, tests do, or that is compiled on demand, or in a folder "
        "that no command names",
        Severity.INFO: "in a file that nothing compiles, next to others or in a package that installs nothing, that "
        "only a switch which is off has, or behind a header of ROS 1",
    },
    examples=(
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
                "include/my_pkg/words.hpp": "inline int words() {return 0;}\n",
                "src/talker.cpp": SOURCE.replace("my_pkg/words.hpp", "«my_pkg/word.hpp»"),
            },
            good={"src/talker.cpp": SOURCE},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
                "src/talker.cpp": "#include <«ros/ros.h»>\n\nint main() {return 0;}\n",
            },
            good={"src/talker.cpp": "int main() {return 0;}\n"},
            on="ament_cmake",
        ),
    ),
)
def missing_header(headers: MissingHeaders) -> Iterator[Hit]:
    """
    ## What it does
    Finds `#include`s of headers of the package, or of another one of the workspace, that do not exist.
    They begin with the name of that package (`my_pkg/words.hpp`), or are nearly called like a header in the same
    folder. So are headers in a folder whose name is one or two letters, or a digit at its end, off that of a package
    that has them, and headers of ROS 1 (`ros/ros.h`, `std_msgs/String.h`), the first of each file that the build
    compiles, and of messages without their kind (`std_msgs/string.hpp`). Of headers that are there it finds the
    first whose folder no command of CMake adds to the include directories of its target.

    ## Why is this bad?
    The compiler stops with "No such file or directory". This is what is left when a header was renamed or moved.

    ## When it is quiet
    Where the build makes a header of that name (`configure_file()`), and, for names that are near to none, where
    programs or commands of other packages may make any, CMake looks outside for a library called like the package, or a
    well-known library has a folder of that name (`pcl/`). Inside of `#if`, in headers that others include there alone,
    in files with `__has_include`, for the path that an install or an export gives a header, where git ignores the
    header or a submodule is not checked out, and in files that nothing compiles or installs. A header that the build
    does not open, though it compiles other sources, or that no test of a package of headers alone includes, while no
    other package here is built with it, may be a leftover: an info. So is what lies below a CMakeLists.txt
    that no other one adds and no page or script builds, one in a package that has no target and installs nothing, one
    in a target that stops at a source of ROS 1 anyway, a name as ROS 1 would have it of an interface that is not known
    (`foo_msgs/Foo.h`), and the first header of ROS 1 where CMake looks for roscpp or catkin, unless package.xml
    declares these.

    ## Fix safety
    The intended header is a guess.
    """
    for first, *others in by_header(headers.all()):
        edits = tuple(Edit(each.path, each.span, each.near) for each in (first, *others))
        fix = Fix(f"include `{first.near}`", edits, Safety.UNSAFE) if first.near else None
        related = tuple(Related(each.path, each.span, "and here") for each in others)
        yield Hit(first.path, first.span, *said(message(first), Severity(first.level), first.behind), related, fix)
    for lost in UnreachedHeaders(headers).first():
        level = Severity.INFO if lost.is_off else Severity.WARNING
        yield Hit(lost.path, lost.span, *said(unreached(lost), level, lost.behind))
    for other in ForeignHeaders(headers).all():
        yield Hit(other.path, other.span, *said(of_no_package(other), Severity(other.level), other.behind))


def said(text: str, level: Severity, behind: Ros1Use | None) -> tuple[str, Severity]:
    """Return a message and its level; an info where what is of ROS 1 ends the build of all that compiles the file."""
    return (text, level) if behind is None else (text + behind.sentence, Severity.INFO)


def unreached(each: UnreachedHeader) -> str:
    of = f" of `{each.target}`" if each.target else ""
    start = f"no command adds `{each.folder}/`, where `{each.header}` is, to the include directories{of}"
    advice = f"add `target_include_directories({each.target or '…'} PUBLIC {each.folder})`"
    return f'{start}: the compiler stops with "No such file"; {advice}'


def by_header(found: Iterable[MissingHeader]) -> Iterable[list[MissingHeader]]:
    """Return the includes of each header together, those that the build certainly compiles first: one cause."""
    same: dict[tuple[str, str], list[MissingHeader]] = {}
    for each in sorted(found, key=lambda each: WORST_FIRST.index(each.level)):
        same.setdefault((each.header, each.near), []).append(each)
    return same.values()


def of_no_package(each: ForeignHeader) -> str:
    stops = 'the compiler stops with "No such file"'
    if each.kind == "folder":
        return f"no package has a header `{each.header}` (did you mean `{each.instead}`?): {stops}; correct the name"
    if each.kind == "unsure":
        return f"`{each.header}` is called like a header of ROS 1: rosidl makes `pkg/msg/name.hpp` of an interface"
    if each.kind == "both":
        return f"`{each.header}` is a header of ROS 1: it compiles only where that, which CMake looks for, is there too"
    instead = f"include `{each.instead}`" if each.instead else "nothing took its place, remove it"
    return f"`{each.header}` is a header of ROS 1: {stops}; {instead}"


def message(each: MissingHeader) -> str:
    near = f" (did you mean `{each.near}`?)" if each.near else ""
    advice = "correct the name" if each.near else "add it, or remove the line"
    return f'`{each.owner}` has no header `{each.header}`{near}: the compiler stops with "No such file"; {advice}'
