"""Libraries that CMake looks for in a folder of its own, where no package manager puts them (DEP104)."""

from __future__ import annotations

from collections.abc import Sequence

from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage

WORDS = ("HINTS", "PATHS", "NO_DEFAULT_PATH")
"""Behind one of these keywords `find_package()` names folders to look into."""
OF_SYSTEM = ("/usr/share", "/usr/lib", "/usr/include", "/usr/cmake", "/opt/ros")
"""Where package managers put libraries."""
OWN = regex(r"\$\{(?:CMAKE_CURRENT_LIST_DIR|(?:CMAKE|PROJECT|CMAKE_CURRENT)_SOURCE_DIR|CMAKE_HOME_DIRECTORY)\}")
"""The folder of a file, or of the project, in a module that looks for a library."""
ELSEWHERE = "; CMake looks for it in a folder that is named here, where it may lie by other ways"


def looks_elsewhere(found: FoundPackage, cmake: CMake) -> bool:
    """Return whether a library may lie in a folder that the package names, or has, for it."""
    texts = found.call.texts
    hints = texts[min((texts.index(word) for word in WORDS if word in texts), default=len(texts)) :]
    names = {f"{found.name}_DIR", f"{found.name}_ROOT", "CMAKE_PREFIX_PATH"}
    sets = (call.texts[1:] for call in cmake.named("set") if call.texts[:1] and call.texts[0] in names)
    lists = (call.texts[2:] for call in cmake.named("list") if list(call.texts[1:2]) == ["CMAKE_PREFIX_PATH"])
    return any(map(names_places, (hints, *sets, *lists))) or has_module(found.name, cmake)


def names_places(words: Sequence[str]) -> bool:
    """Return whether some words name a folder that is none of the system."""
    return any(word not in WORDS and not word.startswith(OF_SYSTEM) for word in words)


def has_module(name: str, cmake: CMake) -> bool:
    """Return whether the package has a module `FindX.cmake` that looks into folders of the package."""
    files = cmake.package_files
    paths = (path for path in files.paths if path.rpartition("/")[2] == f"Find{name}.cmake")
    return any(OWN.search(files.readable_text(path)) for path in paths)
