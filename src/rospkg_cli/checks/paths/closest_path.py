"""The file with the closest name, for a path where there is none."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection

from ...lazy_regex import regex
from ...suggest import near_names, nearest

WORD = regex(r"[^A-Za-z0-9]+")
MARK = 2
"""Letters of a word that only distinguishes similar files, as in `wheel_l` and `wheel_r`."""


def closest_path(path: str, known: Collection[str]) -> str | None:
    """Return the only similar path: a similar name in the same folder, or the same name in another, similar one.

    None where folders have the same names for different things, as `collision/` and `visual/`, or one for each robot.
    """
    folder, name = posixpath.split(path)
    neighbours = {posixpath.basename(each) for each in known if posixpath.dirname(each) == folder}
    if near := nearest(name, {each for each in neighbours if is_like(name, each)}):
        return posixpath.join(folder, near)
    same = {each for each in known if posixpath.basename(each) == name and each != path}
    kind = {each for each in neighbours if posixpath.splitext(each)[1] == posixpath.splitext(name)[1]}
    homes = {posixpath.dirname(each) for each in same}
    if any(posixpath.dirname(each) in homes and posixpath.basename(each) in kind for each in known):
        return None
    if len(same) == 1:
        return same.pop()
    whole = [each for each in homes if each.endswith(f"/{folder}")]
    near = whole[0] if len(whole) == 1 else nearest(folder, homes)
    return posixpath.join(near, name) if near and is_misspelt_folder(folder, near) else None


def is_misspelt_folder(folder: str, other: str) -> bool:
    """Return whether two folders are the same but for slips, or one has a part more; `.` ends what may differ alone."""
    parts, others = ([f"{part}." for part in each.split("/")] for each in (folder, other))
    return len(parts) != len(others) or all(map(is_like, parts, others))


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
    """Return whether a word is a misspelling of another one; a different number or letter (`_l`, `_r`) is none."""
    is_mark = max(len(word), len(other)) <= MARK or re.sub(r"\d+", "", word) == re.sub(r"\d+", "", other)
    return not is_mark and bool(near_names(word, [other]))
