"""LCH010 launch-file-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.installed_launch_files import InstalledLaunchFiles
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import Profile, rule
from ...source import Span

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    wheels = PathJoinSubstitution([FindPackageShare('my_pkg'), 'launch', 'wheels.launch.xml'])
    return LaunchDescription([IncludeLaunchDescription(wheels)])
"""


@rule(
    "LCH010",
    "launch-file-name",
    over=InstalledLaunchFiles,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/robot.py": "«»" + LAUNCH,
                "launch/wheels.launch.xml": "<launch>\n</launch>\n",
            },
            good={"launch/robot.py": None, "launch/robot.launch.py": LAUNCH},
        ),
    ),
)
def launch_file_name(launch: InstalledLaunchFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds installed launch files in Python whose names do not end in `launch.py`.

    ## Why is this bad?
    `ros2 launch` starts them, but does not complete their names, and readers of the folder do not recognize them.

    ## When it is quiet
    Launch files of tests, those that others include by their paths, and Python files that start nothing, are left
    alone.
    """
    for file, better in launch.oddly_named():
        name = file.path.rpartition("/")[2]
        message = f"`{name}` does not end in `launch.py`: `ros2 launch` does not complete it; rename it to `{better}`"
        yield Hit(file.path, Span(0, 0), message)
