"""Which of some headers was intended by the path of one that does not exist."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ...package.cmake.made_headers import HEADERS
from ...suggest import near_names, nearest

SHORT = 10
"""Letters of a file's name from which two may be wrong."""


def near_header(header: str, headers: Iterable[str], may_be_made: bool) -> str:
    """Return the header that is intended: in the same folder, or of the same name in another one; "" for none.

    Where the build may make others, only one that is a letter or two off.
    """
    headers = tuple(headers)
    folder, _, name = header.rpartition("/")
    names = [each.rpartition("/")[2] for each in headers if each.rpartition("/")[0] == folder]
    close = near_file_names(name, names)
    if close or may_be_made:
        return f"{folder}/{close[0]}" if close else ""
    moved = [each for each in headers if each.rpartition("/")[2] == name]
    stems = {each.rpartition(".")[0]: each for each in names}
    stem = name.rpartition(".")[0]
    alike = stem if stem in stems else nearest(stem, stems)
    return moved[0] if len(moved) == 1 else f"{folder}/{stems[alike]}" if alike else ""


def header_next_to(path: str, name: str, paths: Iterable[str]) -> str | None:
    """Return the header in the folder of a file that is one or two letters off a name."""
    folder = posixpath.dirname(path)
    inside = (each for each in paths if posixpath.dirname(each) == folder and each.endswith(HEADERS))
    return next(iter(near_file_names(name, (posixpath.basename(each) for each in inside if each != path))), None)


def without_itself(path: str, headers: frozenset[str]) -> frozenset[str]:
    """Return the headers without the file itself, which can't be what it includes."""
    return frozenset(each for each in headers if not f"/{path}".endswith(f"/{each}"))


def near_file_names(name: str, names: Iterable[str]) -> list[str]:
    """Return the names that are a letter or two off and have the same digits."""
    return near_names(name, with_digits_of(name, names), 1 if len(name) < SHORT else 2)


def is_slip(header: str, near: str) -> bool:
    """Return whether the file of a header has another ending than one that is near, or is a letter or two off."""
    written, name = posixpath.basename(header), posixpath.basename(near)
    is_same = written.partition(".")[0] == name.partition(".")[0]
    return is_same or bool(near_names(written, [name], 1 if len(written) < SHORT else 2))


def with_digits_of(name: str, names: Iterable[str]) -> list[str]:
    """Return the names with the same digits: `v1.hpp` and `v2.hpp` are no misspellings of each other."""
    wanted = list(filter(str.isdecimal, name))
    return [each for each in names if list(filter(str.isdecimal, each)) == wanted]
