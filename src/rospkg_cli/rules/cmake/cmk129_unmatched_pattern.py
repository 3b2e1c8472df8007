"""CMK129 unmatched-pattern."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.built_for_ros1 import is_built_for_ros1
from ...checks.cmake.unmatched_patterns import UnmatchedPatterns
from ...checks.enumeration import in_ticks
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

LINES = 'install(DIRECTORY «launch» DESTINATION share/${PROJECT_NAME} FILES_MATCHING PATTERN "*.launch")\n'
LAUNCH = "<launch/>\n"


@rule(
    "CMK129",
    "unmatched-pattern",
    over=UnmatchedPatterns,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "another rule installs these files, it is in a function, all sources are of ROS 1, or nothing "
        "is known to include the headers or to open the files"
    },
    examples=(
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", f"{LINES}ament_package"),
                "launch/robot.launch.xml": LAUNCH,
            },
            good={
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package", f"{LINES}ament_package".replace("«launch»", "launch").replace("*.launch", "*.xml")
                )
            },
            on="ament_cmake",
        ),
    ),
)
def unmatched_pattern(patterns: UnmatchedPatterns) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders that are installed with FILES_MATCHING and a PATTERN that none of their files fits.
    It reports folders that have files of the same purpose with another ending: headers (`.h`, `.hpp`), launch files,
    parameters, meshes, robots or pictures.

    ## Why is this bad?
    CMake makes an empty folder and says nothing: who includes the headers or starts the launch file does not find it.

    ## When it is quiet
    For other patterns than `*.ending` and for REGEX, where another rule with FILES_MATCHING takes the files, where git
    ignores or the build makes such files, for folders that are not there (CMK102), and below a condition that can't be
    evaluated. It is an info in a function or a macro, which others may call for other folders, and where another
    pattern takes files of the folder to a place that is not known; and where CMake chooses between ament and catkin
    and all sources are of ROS 1. So it is where nothing is known to look for the files: no package of the workspace
    that looks for this one includes a header, or nothing opens the files. Launch files are there to be started.
    """
    for each in patterns.all():
        names = in_ticks(each.patterns)
        start = f"no file of `{each.folder}` fits {names} (`{each.others[0]}` does not): nothing is installed here"
        if each.is_installed:
            yield Hit(each.item.path, each.item.span, f"{start}; another rule does so, remove this one", Severity.INFO)
        elif each.is_harmless:
            advice = "remove the rule where no folder has such files"
            yield Hit(each.item.path, each.item.span, f"{start}; {advice}", Severity.INFO)
        else:
            is_met = patterns.are_wanted(each) and not is_built_for_ros1(patterns.package.cmake)
            level = None if is_met else Severity.INFO
            yield Hit(each.item.path, each.item.span, f"{start}; correct the pattern", level)
