"""The file with the closest name, for a path where there is none."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection

from ..lazy_regex import regex
from ..suggest import near_names, nearest

WORD = regex(r"[^A-Za-z0-9]+")
MARK = 2
"""Letters of a word that tells siblings apart, as in `wheel_l` and `wheel_r`."""


def closest_path(path: str, known: Collection[str]) -> str | None:
    """Return the only similar path: a similar name in the same folder, or the same name in another, similar one."""
    folder, name = posixpath.split(path)
    neighbours = {posixpath.basename(each) for each in known if posixpath.dirname(each) == folder}
    if near := nearest(name, {each for each in neighbours if is_like(name, each)}):
        return posixpath.join(folder, near)
    same = {each for each in known if posixpath.basename(each) == name and each != path}
    if len(same) == 1:
        return same.pop()
    near = nearest(folder, {posixpath.dirname(each) for each in same})
    return posixpath.join(near, name) if near else None


def is_like(name: str, other: str) -> bool:
    """Return whether two files have the same words but for slips, or one has a word more: none is another's sibling.

    `slam_params.yaml` is none of `nav_params.yaml`, and `wheel_1.stl` none of `wheel_2.stl`.
    """
    words, others = WORD.split(name.lower()), WORD.split(other.lower())
    if "".join(words) == "".join(others):
        return True
    if len(words) == len(others):
        return all(a == b or is_misspelt(a, b) for a, b in zip(words, others, strict=True)) or words[:-1] == others[:-1]
    longer, shorter = sorted((words, others), key=len, reverse=True)
    return len(longer) == len(shorter) + 1 and any(
        longer[:at] + longer[at + 1 :] == shorter for at in range(len(longer))
    )


def is_misspelt(word: str, other: str) -> bool:
    """Return whether a word is another one with a slip, none of them a number or a letter that tells siblings apart."""
    is_mark = max(len(word), len(other)) <= MARK or re.sub(r"\d+", "", word) == re.sub(r"\d+", "", other)
    return not is_mark and bool(near_names(word, [other]))
