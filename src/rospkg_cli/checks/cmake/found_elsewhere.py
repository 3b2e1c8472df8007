"""Whether CMake may find a package by what is not here: repositories that are listed, folders and projects outside."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import Word
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace

PATHS = frozenset({"CMAKE_MODULE_PATH", "CMAKE_PREFIX_PATH"})
"""Where CMake looks for `Find<name>.cmake` and for config files."""
FETCHING = ("fetchcontent_declare", "externalproject_add", "cpmaddpackage", "cpmfindpackage")


def may_be_found_elsewhere(name: str, cmake: CMake, workspace: Workspace) -> bool:
    """Return whether an unknown package may exist: CMake fetches it, or looks in places that are not here."""
    is_open = not workspace.is_complete or any(True for _ in looks_outside(cmake))
    return is_open or is_fetched(name, cmake) or any(sets_place(call, name) for call in cmake.named("set"))


def looks_outside(cmake: CMake) -> Iterator[Word]:
    """Yield the folders outside of the package in which CMake looks, and those that are not known."""
    for call in cmake.named("set", "list"):
        if not PATHS.isdisjoint(call.texts[:2]):
            at = 1 + (call.name == "list")
            for word in call.words[at:]:
                is_itself = any(each in cmake.source_text(word) for each in PATHS)
                if not is_itself and (not word.is_known or path_in_package(word.text, call.folder) is None):
                    yield word


def is_fetched(name: str, cmake: CMake) -> bool:
    small = name.lower()
    return any(small in text.lower() for call in cmake.named(*FETCHING) for text in call.texts)


def sets_place(call: EvaluatedCommand, name: str) -> bool:
    return any(text in (f"{name}_DIR", f"{name}_ROOT") for text in call.texts[:1])
