"""Where the cache lies: a folder that belongs to the user and that no other user can write."""

from __future__ import annotations

import os
import stat
import sys

TYPE_CHECKING = False  # typing's own would cost a start some milliseconds
if TYPE_CHECKING:
    from collections.abc import Mapping

TAG = (
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# This file marks a cache of rospkg, which backups may leave out: https://bford.info/cachedir/\n"
)


def cache_folder(environment: Mapping[str, str]) -> str:
    """Return the folder, whether or not it is there: in $XDG_CACHE_HOME, else where the system has caches; or ""."""
    home = environment.get("HOME") or environment.get("USERPROFILE") or ""
    place = environment.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(place):  # the specification wants such a value passed over
        if sys.platform == "win32":
            place = environment.get("LOCALAPPDATA", "")
        elif os.path.isabs(home):
            place = f"{home}/Library/Caches" if sys.platform == "darwin" else f"{home}/.cache"
    return os.path.join(place, "rospkg", "lint") if os.path.isabs(place) else ""


def is_safe(folder: str) -> bool:
    """Return whether a folder is there, belongs to the user, and can't be written by others."""
    try:
        found = os.lstat(folder)
    except OSError:
        return False
    if not stat.S_ISDIR(found.st_mode):
        return False
    return sys.platform == "win32" or (found.st_uid == os.geteuid() and not found.st_mode & 0o022)


def make_folder(folder: str) -> bool:
    """Make the folder of the cache where it is missing; return whether it may be used."""
    if is_safe(folder):
        return True
    try:
        os.makedirs(os.path.dirname(folder), exist_ok=True)
        os.mkdir(folder, 0o700)
        with open(os.path.join(folder, "CACHEDIR.TAG"), "x", encoding="ascii") as stream:
            stream.write(TAG)
    except OSError:
        pass
    return is_safe(folder)
