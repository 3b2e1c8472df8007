"""Files that `ros2 launch` takes, though their names do not say so: of launch/, and a bare `.launch`."""

from __future__ import annotations

import re

from ..files import PackageFiles
from ..lazy_regex import regex

LAUNCH = "launch/"
OF_ROS2 = regex(r"\sexec\s*=|\$\((?:find-pkg-share|var)\s")
SIGNS = {
    ".py": regex(r"^def generate_launch_description\b", re.MULTILINE),
    ".xml": OF_ROS2,
    ".yaml": regex(r"^launch[ ]*:", re.MULTILINE),
    ".yml": regex(r"^launch[ ]*:", re.MULTILINE),
}
"""What each frontend of launch starts from."""


def is_started(files: PackageFiles, path: str) -> bool:
    """Return whether a bare `.launch` is written for ROS 2, or launch can start a file of any name in launch/."""
    ending = f".{path.rpartition('.')[2]}"
    sign = OF_ROS2 if ending == ".launch" else SIGNS.get(ending) if path.startswith(LAUNCH) else None
    if sign is None:
        return False
    text = files.readable_text(path)
    return sign.search(text) is not None and (ending != ".xml" or "<launch" in text)
