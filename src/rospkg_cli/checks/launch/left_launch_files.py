"""Launch files that are left over: older copies by their names, and files that were never ported to ROS 2."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import is_set_aside, role_of
from ...package.launch.live_text import MARKUP, OF_ROS1
from ...package.launch.text import uncommented
from ...ros.launch_entities import ROS1_ENTITIES

OF_ROS2 = (".launch.xml", "_launch.xml")
"""How the names of launch files for ROS 2 end, which those for ROS 1 do not."""
TAG = regex(r"<(\w+)")


def is_given_up(path: str, files: PackageFiles) -> bool:
    """Return whether a launch file is a copy of another, or was never ported to ROS 2 as a whole."""
    return role_of(path) == "launch" and (is_copy(path, files) or is_unported(path, files))


def is_copy(path: str, files: PackageFiles) -> bool:
    """Return whether the name of a launch file marks it as an older copy.

    That is `a_old.launch.py`, or `a.py` next to `a.launch.py`.
    """
    stem = path.removesuffix(".py")
    is_bare = stem != path and not stem.endswith("launch")
    newer = (f"{stem}.launch.py", f"{stem}_launch.py") if is_bare else ()
    return is_set_aside(path) or any(map(files.has_file, newer))


def is_unported(path: str, files: PackageFiles) -> bool:
    """Return whether a launch file still has nodes by `type=`, `$(find …)` or `$(arg …)`, at which ROS 2 refuses it.

    The only launch file of a package does not count, nor one that is named as for ROS 2, unless it has nothing but
    settings of ROS 1: MoveIt's setup assistant called such files `….launch.xml`, too.
    """
    others = [each for each in files.paths if role_of(each) == "launch" and each != path]
    if not path.endswith(MARKUP) or not others:
        return False
    text = uncommented(".launch", files.readable_text(path))
    return has_settings_alone(text) or (not path.endswith(OF_ROS2) and OF_ROS1.search(text) is not None)


def has_settings_alone(text: str) -> bool:
    """Return whether a launch file starts and includes nothing, and has what ROS 1 alone takes among the actions."""
    tags = set(TAG.findall(text))
    return not tags.isdisjoint(ROS1_ENTITIES) and tags <= {"launch", "group", "arg", *ROS1_ENTITIES}
