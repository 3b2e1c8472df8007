"""Whether CMake may install a header, so that other packages include it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import path_in_package
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands


def may_be_installed(cmake: CMake, path: str) -> bool:
    """Return whether a header may be installed: a command installs it, or one that is unknown here may do so."""
    is_known = cmake.is_complete and cmake.ends_a_package and not cmake.includes_unknown_files
    is_automatic = any(call.name.endswith("ament_auto_package") for call in cmake.calls)
    if not is_known or is_automatic or next(foreign_commands(cmake), None) is not None:
        return True
    for rule in cmake.installs:
        if rule.kind == "CODE" or any("HEADER" in text or text == "FILE_SET" for text in rule.call.texts):
            return True
        paths = [path_in_package(word.text, rule.call.folder) if word.is_known else "" for word in rule.items]
        if rule.kind != "TARGETS" and any(f"{path}/".startswith(f"{each}/" if each else "") for each in inside(paths)):
            return True
    return False


def inside(paths: Iterable[str | None]) -> Iterator[str]:
    """Yield the paths in the package, normalized; None stands for a path outside of it."""
    return (posixpath.normpath(each).strip("./") for each in paths if each is not None)
