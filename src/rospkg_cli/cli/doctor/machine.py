"""The program itself, the ROS that is sourced, and the cache."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Collection
from pathlib import Path

from ... import __version__
from ...cache.folder import cache_folder, is_safe
from ...cache.prune import kept_files
from ...report.summary import counted
from ...ros.distros import fault_of_name
from .topic import Topic

MEGABYTE = 1_000_000


def program() -> Topic:
    """Return the version, the Python that runs it, and where it is installed."""
    python, system = platform.python_version(), f"{platform.system()} {platform.release()}"
    place = str(Path(__file__).parents[2])
    data = {"version": __version__, "python": python, "executable": sys.executable, "platform": system, "path": place}
    return Topic("rospkg", (f"{__version__}, Python {python} on {system}, in {place}",), data)


def ros(installed: Collection[str]) -> Topic:
    """Return the distribution that is sourced; `installed` has the names of the packages of its prefixes."""
    distro = os.environ.get("ROS_DISTRO", "")
    prefixes = [each for each in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if each]
    data = {"distro": distro or None, "prefixes": prefixes, "packages": len(installed)}
    if not distro and not prefixes and not installed:
        return Topic("ROS", ("none is sourced, and none is needed",), data)
    count = f"{counted(len(installed), 'package')}, AMENT_PREFIX_PATH names {counted(len(prefixes), 'folder')}"
    if distro and (fault := fault_of_name(distro)):
        return Topic("ROS", (f"{distro}, {count}",), data, f"$ROS_DISTRO is not used: {fault}")
    return Topic("ROS", (f"{distro or 'no $ROS_DISTRO'}, {count}",), data)


def cache() -> Topic:
    """Return where lint keeps what it found, and how large that is."""
    folder = cache_folder(os.environ)
    data: dict[str, object] = {"path": folder or None, "files": 0, "bytes": 0}
    if not folder:
        return Topic("cache", ("none: neither XDG_CACHE_HOME nor HOME is set",), data)
    if is_safe(folder):
        sizes = [size for _, size, _ in kept_files(folder)]
        data |= {"files": len(sizes), "bytes": sum(sizes)}
        return Topic("cache", (f"{folder}, {counted(len(sizes), 'file')}, {sum(sizes) / MEGABYTE:,.1f} MB",), data)
    if os.path.lexists(folder):
        advice = "it must be a folder of yours that no one else can write; remove it"
        return Topic("cache", (f"{folder} is not used",), data, advice)
    return Topic("cache", (f"{folder}, nothing is kept yet",), data)
