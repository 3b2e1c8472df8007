"""The file with the closest name, for a path where there is none."""

from __future__ import annotations

import posixpath
from collections.abc import Collection

from ..suggest import nearest


def closest_path(path: str, known: Collection[str]) -> str | None:
    """Return the only similar path: a similar name in the same folder, or the same name in another, similar one."""
    folder, name = posixpath.split(path)
    neighbours = {posixpath.basename(each) for each in known if posixpath.dirname(each) == folder}
    if near := nearest(name, neighbours):
        return posixpath.join(folder, near)
    same = {each for each in known if posixpath.basename(each) == name and each != path}
    if len(same) == 1:
        return same.pop()
    near = nearest(folder, {posixpath.dirname(each) for each in same})
    return posixpath.join(near, name) if near else None
