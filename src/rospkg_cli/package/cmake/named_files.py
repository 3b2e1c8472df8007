"""Whether commands of CMake name a file of the package, as launch tests are named."""

from __future__ import annotations

from fnmatch import fnmatchcase

from ...languages.cmake.values import UNKNOWN
from .cmake_project import CMake


def mentions_file(cmake: CMake, path: str) -> bool:
    """Return whether a command names a file, with or without its suffixes, or a launch test may do so."""
    name = path.rpartition("/")[2]
    wanted = (name, name.partition(".")[0], name.rpartition(".")[0])
    for call in cmake.calls:
        if call.may_have_more and any(each in call.name for each in ("launch", "ros_test", "pytest")):
            return True
        for last in (text.rpartition("/")[2] for text in call.texts):
            if last in wanted or (
                UNKNOWN in last and last.strip(UNKNOWN) and fnmatchcase(name, last.replace(UNKNOWN, "*"))
            ):
                return True
    return False
