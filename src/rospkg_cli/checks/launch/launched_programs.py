"""Python files among launch files that are programs: nodes and tools that somebody keeps there."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.launch.launch_evaluator import ENTRIES
from ...package.launch.launch_file import LaunchFile
from ...package.launch.live_text import MARKUP, is_for_ros1

LAUNCH = "launch"
"""What the packages of launch begin with: `launch_ros`, `launch_testing`, `launch_param_builder`."""
DESCRIBES = regex(
    r"(?m)\bgenerate_(?:launch|test)_description\b|^\s*(?:from|import)\s+launch|^\s*from\s+\S+\s+import\s+\*"
)
"""What a Python file has that launch may load: an entry point, a package of launch, or all names of a module."""
RUNS = regex(r"(?m)^\s*(?:from|import)\s+(?:rospy|roslaunch|rclpy)\b|\b__main__\b")
"""What a program has."""


def launches_nothing(files: PackageFiles, path: str) -> bool:
    """Return whether a file among launch files is none that `ros2 launch` can load: a program, or one for ROS 1."""
    if path.endswith(".py"):
        text = files.readable_text(path)
        return RUNS.search(text) is not None and DESCRIBES.search(text) is None
    return path.endswith(MARKUP) and is_for_ros1(files.readable_text(path))


def is_program(file: LaunchFile) -> bool:
    """Return whether a Python file among launch files is a program: it describes no launch, and imports nothing of it.

    A file that takes all names of a module may have its launch description from there.
    """
    python = file.python
    if python is None or python.star_imports or not python.definitions.keys().isdisjoint(ENTRIES):
        return False
    return not any(each.module.startswith(LAUNCH) for each in file.imports)
