"""Libraries that CMake takes from /usr/local or /opt, where builds from source install (DEP104, DEP105, DEP115)."""

from __future__ import annotations

from collections.abc import Collection

from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from .hand_installs import plain

PLACE = regex(r"(?:-[LI])?(/usr/local/\S+\.(?:so[\d.]*|a)|/opt/(?!ros\b)\S+)")
"""A library below a folder into which apt puts nothing, or a folder for one; a missing folder alone stops no build."""
LOOKS = regex(r"find_(?:path|file|library|program)")
"""Commands that search the folders of the system as well."""
END = regex(r"\.(?:so[\d.]*|a|hpp|h|cmake)$")
OUTSIDE_APT = "; CMake takes it from `{}`, where the key does not put it"


def place_outside_apt(cmake: CMake, names: Collection[str]) -> str:
    """Return a path in CMake that has one of the names of a library as a part; "" for none."""
    wanted = {plain(END.sub("", each.partition("/")[0])) for each in names} - {""}
    for call in cmake.calls:
        looks_around = LOOKS.fullmatch(call.name) and "NO_DEFAULT_PATH" not in call.texts
        for word in () if looks_around else call.words:
            found = PLACE.match(word.text) if word.is_known else None
            if found and not wanted.isdisjoint(plain(END.sub("", part)) for part in found[1].split("/")):
                return found[1]
    return ""
