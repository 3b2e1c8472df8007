"""CMK121 unlinked-include."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.depends.idle_links import IdleLink, idle_links
from ...checks.depends.own_interfaces import OwnInterface, OwnInterfaces
from ...checks.depends.unlinked_includes import UnlinkedInclude, UnlinkedIncludes
from ...checks.depends.unlinked_sentences import is_met, lacking
from ...checks.enumeration import in_ticks
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule

NODE = CMAKE.replace(
    "ament_package()",
    "find_package(rclcpp REQUIRED)\nfind_package({found} REQUIRED)\nadd_executable(node src/node.cpp)\n"
    "target_link_libraries(node rclcpp::rclcpp{linked})\n"
    "install(TARGETS node DESTINATION lib/${{PROJECT_NAME}})\nament_package()",
).replace("${PROJECT_NAME})\nament", "${{PROJECT_NAME}})\nament")


def example(package: str, header: str, linked: str) -> Example:
    text = NODE.replace("{found}", package).replace("{{", "{").replace("}}", "}")
    body = f"  <depend>rclcpp</depend>\n  <depend>{package}</depend>\n"
    return Example(
        on="ament_cmake",
        bad={
            "CMakeLists.txt": text.replace("{linked}", ""),
            "package.xml": manifest(body, "ament_cmake"),
            "src/node.cpp": f"#include <rclcpp/rclcpp.hpp>\n#include <«{header}»>\nint main() {{return 0;}}\n",
        },
        good={"CMakeLists.txt": text.replace("{linked}", f" {linked}")},
    )


@rule(
    "CMK121",
    "unlinked-include",
    over=UnlinkedIncludes,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where another package's folder of headers may hold them as well, or another one that the "
        "target is linked with may bring them, or a library is given in vain, or the repository is for distributions "
        "before Humble, or a source of ROS 1 ends the build of the target"
    },
    examples=(
        example("sensor_msgs", "sensor_msgs/msg/image.hpp", "${sensor_msgs_TARGETS}"),
        example("tf2_ros", "tf2_ros/buffer.h", "tf2_ros::tf2_ros"),
    ),
)
def unlinked_include(includes: UnlinkedIncludes) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets that include headers of a package that CMake finds, and are not linked with it.
    `find_package()` alone adds no include directory to a target: `target_link_libraries()` does, or
    `ament_target_dependencies()` up to Kilted. So are the headers of the package's own interfaces, which come with what
    `rosidl_get_typesupport_target()` returns. octomap, ompl and yaml-cpp set no variable that
    `ament_target_dependencies()` reads, so that it links nothing of them: an info.

    ## Why is this bad?
    From Humble on each package has a folder of headers of its own, so the build ends with "No such file or directory";
    at the latest the linker misses the symbols.

    ## When it is quiet
    The package's own interfaces bring what `rosidl_generate_interfaces()` is given as DEPENDENCIES. What a target is
    linked with brings what it passes on itself, as far as package.xml says, and the CMake of a package of the
    workspace (what it is linked with as PRIVATE stays there), and so do the folders of a package
    (`${tf2_INCLUDE_DIRS}`); where one link or folder is not known, nothing is said of the target, and where that is not
    known of one package, or it brings it on some distributions alone, all that it may bring is one info. What rclcpp is
    linked with for itself alone from Jazzy on, as it is with ament_index_cpp, it does not bring; where the run checks
    for Humble alone, or nothing of the repository names Jazzy or a later distribution (but to say that it does not work
    there), that is an info, and all is where pages, scripts and workflows name distributions before Humble alone. A
    target with a source that includes headers of ROS 1 (`ros/ros.h`, `std_msgs/String.h`) or calls `ros::NodeHandle`
    and the like stops there: an info, as is one that a plain build leaves out (EXCLUDE_FROM_ALL). A header that no
    package of interfaces has, as rosidl makes `std_msgs/msg/string.hpp` alone, is not a matter of linking. Targets of
    `ament_auto_add_…()`, includes under `#if`, and calls under a condition are left alone.

    ## References
    - [ament_cmake user documentation](https://docs.ros.org/en/rolling/How-To-Guides/Ament-CMake-Documentation.html)
    """
    if hit := without_own(list(OwnInterfaces(includes).all())):
        yield hit
    yield from map(given_in_vain, idle_links(includes))
    found = list(includes.all())
    for each in (each for each in found if not each.bringer):
        level = None if is_met(each, includes.distribution) else Severity.INFO
        yield Hit(each.path, each.span, lacking(each, includes.distribution), level)
    perhaps = [each for each in found if each.bringer]
    for target in dict.fromkeys(each.target.name for each in perhaps):
        yield perhaps_brought([each for each in perhaps if each.target.name == target])


def given_in_vain(each: IdleLink) -> Hit:
    """Return the hit of a library that the target is given and does not get."""
    name, (folders, libraries) = each.link.word.text, each.variables
    message = (
        f"`ament_target_dependencies` reads `{name}_INCLUDE_DIRS` and `{name}_LIBRARIES`, and `{name}` has "
        f"`{folders}` and `{libraries}` alone: `{each.link.target}` gets nothing of it unless another "
        "package brings it; link it with `target_link_libraries`"
    )
    related = (Related(each.path, each.include.span, "it is included here"),)
    return Hit(each.link.word.path, each.link.word.span, message, Severity.INFO, related)


def without_own(found: Sequence[OwnInterface]) -> Hit | None:
    """Return the hit of all targets that include what is generated here and are not linked with it."""
    if not found:
        return None
    first, *others = sorted(found, key=lambda each: each.behind is not None)
    start = f"`{first.header}` is generated in this package, and `{first.target.name}` is not linked with it"
    link = "link what `rosidl_get_typesupport_target()` returns"
    related = tuple(Related(each.path, each.span, f"`{each.target.name}` lacks it, too") for each in others)
    message = f'{start}: the build ends with "No such file or directory"; {link}'
    behind, level = ("", None) if first.behind is None else (first.behind.sentence, Severity.INFO)
    return Hit(first.path, first.span, message + behind, level, related)


def perhaps_brought(found: Sequence[UnlinkedInclude]) -> Hit:
    """Return one info for all that a target lacks, and that a package may bring whose dependencies are not known."""
    first, *others = found
    names = in_ticks(dict.fromkeys(each.package for each in found))
    are, them = ("are", "them") if others else ("is", "it")
    message = (
        f"{names} {are} included, and `{first.target.name}` is not linked with {them}: it builds only while "
        f"`{first.bringer}` or the like brings the headers; add {them} to its `target_link_libraries()`"
    )
    related = [Related(each.path, each.span, f"`{each.header}` is included here") for each in others]
    return Hit(first.path, first.span, message, Severity.INFO, tuple(related))
