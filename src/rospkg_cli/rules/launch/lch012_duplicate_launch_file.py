"""LCH012 duplicate-launch-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.installed_launch_files import InstalledLaunchFiles
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

EMPTY = "<launch>\n</launch>\n"
BAD = CMAKE.replace("ament_package", "install(DIRECTORY «launch» DESTINATION share/${PROJECT_NAME})\nament_package")


@rule(
    "LCH012",
    "duplicate-launch-file",
    over=InstalledLaunchFiles,
    severity=Severity.WARNING,
    examples=(
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": BAD, "launch/sim/robot.launch.xml": EMPTY, "launch/real/robot.launch.xml": EMPTY},
            good={"launch/real/robot.launch.xml": None, "launch/real/real_robot.launch.xml": EMPTY},
        ),
    ),
)
def duplicate_launch_file(launch: InstalledLaunchFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch files that are installed under one name in several folders of a share directory.

    ## Why is this bad?
    `ros2 launch my_pkg robot.launch.xml` looks through all folders and stops with "file 'robot.launch.xml' was found
    more than once in the share directory of package 'my_pkg'".

    ## When it is quiet
    Left alone are files that are all included by their paths, as no one has to start them by name, and files of which
    CMake installs several only under conditions, such as one for each distribution.
    """
    for row, name, paths in launch.doubles():
        where = " and ".join(f"`{path}`" for path in paths[:3]) + (" and others" if paths[3:] else "")
        message = (
            f"{where} are installed under one name: `ros2 launch {launch.package.name} {name}` finds all and stops; "
            f"rename all but one"
        )
        yield Hit(row.path, row.span, message)
