"""The block of a new target in CMakeLists.txt."""

from __future__ import annotations

from ..change import ChangeError, NotUnderstoodError, Paste
from ..finding import Edit
from ..package.cmake.cmake_project import CMake
from .cmake_block import put_before_installs


def put_target(cmake: CMake, name: str, source: str, lines: str) -> tuple[Edit, ...]:
    """Return the edits that put in a target; nothing where it is there with its source already.

    Raises ChangeError where another target has the name, NotUnderstoodError where no place for the lines is found.
    """
    target = cmake.target(name)
    if target is not None:
        if any(word.text.endswith(source) for word in target.sources):
            return ()
        raise ChangeError(f"CMakeLists.txt has a target `{name}` already; choose another name")
    edits = put_before_installs(cmake.root, lines)
    if not edits:
        raise NotUnderstoodError(
            "CMakeLists.txt has no ament_package() at its end: put the lines where the targets are, and run the "
            "command again",
            Paste("CMakeLists.txt", lines),
        )
    return edits
