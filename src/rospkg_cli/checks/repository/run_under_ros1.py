"""Scripts for ROS 1: a page, a script or a container of the repository runs them where ROS 1 is installed."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from .container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

RELEASES = r"(?:hydro|indigo|jade|kinetic|lunar|melodic|noetic)\b"
OF_ROS1 = regex(rf"(?i)/opt/ros/{RELEASES}|\bros:{RELEASES}|\bROS_DISTRO[=: ]+[\"']?{RELEASES}")
"""The folder of a release of ROS 1, or its image, which no machine with only ROS 2 has."""
STARTS = regex(r"(?<![\w-])roscore\b")
COMMENT = regex(r"(?m)^[ \t]*#.*$")
HEADING = regex(r"#{1,6}[ \t]")
FENCE = regex(r"[ \t]*(?:```|~~~)")
UNDERLINE = regex(r"([=~^\-*\"'`+])\1{3,}[ \t]*$")
PAGES = (".md", ".rst")
CODE = regex(r"\.py$")
RUN_UNDER_ROS1 = "; `{}` runs it under ROS 1, for which it is written"


def why_for_ros1(files: PackageFiles, path: str) -> str:
    """Return that something of the repository runs a script under ROS 1, as the end of a sentence; "" for others."""
    name = path.rpartition("/")[2]
    word = re.compile(rf"(?<![\w.-]){'' if '.' in name else '(?<=/)'}{re.escape(name)}(?![\w.-]*\w)")
    by_package = re.compile(rf"\b(?:rosrun|ros2[ \t]+run)[ \t]+\S+[ \t]+{re.escape(name)}")
    for whole, text_path in files_called(files, OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, CODE):
        if not whole.holds(text_path, name.encode()) or text_path.rpartition("/")[2] in (name, "setup.py"):
            continue
        is_page = text_path.endswith(PAGES)
        text = whole.readable_text(text_path)
        for part in sections(text) if is_page else [COMMENT.sub("", text)]:
            is_there = OF_ROS1.search(part) or (not is_page and STARTS.search(part))
            if is_there and word.search(by_package.sub("", part)):
                return RUN_UNDER_ROS1.format(text_path.rpartition("/")[2])
    return ""


def sections(text: str) -> Iterator[str]:
    """Yield what stands between the headings of a page; a `#` in a block of code begins none."""
    lines = list[str]()
    is_code = False
    for line in text.split("\n"):
        is_code ^= FENCE.match(line) is not None
        if not is_code and (HEADING.match(line) or UNDERLINE.match(line)):
            yield "\n".join(lines)
            lines.clear()
        lines.append(line)
    yield "\n".join(lines)
