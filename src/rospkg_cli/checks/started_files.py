"""Files that `ros2 launch` takes, though their names do not say so, and those among launch files that it does not."""

from __future__ import annotations

import re

from ..files import PackageFiles
from ..lazy_regex import regex
from ..package.launch.live_text import MARKUP, is_for_ros1

LAUNCH = "launch/"
OF_ROS2 = regex(r"\sexec\s*=|\$\((?:find-pkg-share|var)\s")
SIGNS = {
    ".py": regex(r"^def generate_launch_description\b", re.MULTILINE),
    ".xml": OF_ROS2,
    ".yaml": regex(r"^launch[ ]*:", re.MULTILINE),
    ".yml": regex(r"^launch[ ]*:", re.MULTILINE),
}
"""What each frontend of launch starts from."""
DESCRIBES = regex(
    r"(?m)\bgenerate_(?:launch|test)_description\b|^\s*(?:from|import)\s+launch|^\s*from\s+\S+\s+import\s+\*"
)
"""What a Python file has that launch may load: an entry point, a package of launch, or all names of a module."""
RUNS = regex(r"(?m)^\s*(?:from|import)\s+(?:rospy|roslaunch|rclpy)\b|\b__main__\b")
"""What a program has."""


def is_started(files: PackageFiles, path: str) -> bool:
    """Return whether a bare `.launch` is written for ROS 2, or launch can start a file of any name in launch/."""
    ending = f".{path.rpartition('.')[2]}"
    sign = OF_ROS2 if ending == ".launch" else SIGNS.get(ending) if path.startswith(LAUNCH) else None
    if sign is None:
        return False
    text = files.readable_text(path)
    return sign.search(text) is not None and (ending != ".xml" or "<launch" in text)


def launches_nothing(files: PackageFiles, path: str) -> bool:
    """Return whether a file among launch files is none that `ros2 launch` can load: a program, or one for ROS 1."""
    if path.endswith(".py"):
        text = files.readable_text(path)
        return RUNS.search(text) is not None and DESCRIBES.search(text) is None
    return path.endswith(MARKUP) and is_for_ros1(files.readable_text(path))
