"""Places of C++ under a macro that nothing in a package defines: the build leaves them out."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...languages.cpp.asked_macros import asked_macros
from ...lazy_regex import regex

OF_COMPILERS = regex(r"_\w*|NDEBUG|(?:linux|unix)|\w*(?:ROS|DISTRO|VERSION|HAVE)\w*")
"""What compilers, distributions and libraries define; a check of CMake for some library does `HAVE_X`."""
OF_OTHER_SYSTEMS = frozenset({"_WIN32", "_WIN64", "WIN32", "__APPLE__", "_MSC_VER", "__ANDROID__"})
DEFINING = ("CMakeLists.txt", ".cmake", ".h", ".hpp", ".hh", ".cpp", ".cc", ".cxx", ".sh", ".yaml", ".yml", ".in")


def is_left_out(text: str, at: int, files: PackageFiles) -> bool:
    """Return whether an `#if` around a place asks for a macro that no line of the package may define."""
    return any(not may_be_defined(macro, files) for macro in asked_macros(text, at))


def may_be_defined(macro: str, files: PackageFiles) -> bool:
    if macro in OF_OTHER_SYSTEMS or macro.isdigit():
        return False
    if OF_COMPILERS.fullmatch(macro):
        return True
    elsewhere = re.compile(rf"(?m)^(?![ \t]*#[ \t]*(?:if|el|endif)).*\b(?:D_?)?{macro}\b")
    texts = (files.readable_text(each) for each in files.paths if each.endswith(DEFINING))
    return any(macro in text and elsewhere.search(text) is not None for text in texts)
