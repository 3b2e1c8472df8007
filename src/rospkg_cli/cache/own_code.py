"""What rospkg itself is: its sources, and the versions of what is installed with it.

A version alone would not do: a checkout changes without one, and so does a package that is installed anew from git.
"""

from __future__ import annotations

import os
import sys

from ..disk_trace import YOUNG, digest

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INSTALLED = (".dist-info", ".egg-info", ".pth", ".egg-link")
"""Endings of the names that tell what is installed in a folder, and in which version."""


def source_files() -> list[os.DirEntry[str]]:
    """Return the files that rospkg is made of, by path; raises OSError."""
    waiting, found = [HERE], []
    schemas = os.path.join(os.path.dirname(os.path.dirname(HERE)), "schemas")
    if os.path.isdir(schemas) and not os.path.isdir(os.path.join(HERE, "_schemas")):
        waiting.append(schemas)  # a checkout
    while waiting:
        with os.scandir(waiting.pop()) as entries:
            for entry in entries:
                if not entry.is_dir(follow_symlinks=False):
                    found.append(entry)
                elif entry.name != "__pycache__":
                    waiting.append(entry.path)
    return sorted(found, key=lambda entry: entry.path)


def code_signature() -> str:
    """Return what changes when a source does, without reading it; "" where one changed a moment ago."""
    from time import time_ns

    found = [entry.stat() for entry in source_files()]
    if max(max(each.st_mtime_ns, each.st_ctime_ns) for each in found) > time_ns() - YOUNG:
        return ""
    return str(hash(tuple((s.st_mtime_ns, s.st_ctime_ns, s.st_size, s.st_ino) for s in found)))


def code_digest() -> str:
    """Return a digest of all sources."""
    texts = []
    for entry in source_files():
        with open(entry.path, "rb") as stream:
            texts.append(digest(os.fsencode(entry.path) + b"\0" + stream.read()))
    return digest("".join(texts).encode())


def installed_in(folder: str) -> str:
    """Return the names of what is installed in a folder of Python's search path."""
    try:
        return "/".join(sorted(name for name in os.listdir(folder) if name.endswith(INSTALLED)))
    except OSError:
        return "-"


def search_path() -> list[str]:
    return [folder for folder in sys.path if folder]
