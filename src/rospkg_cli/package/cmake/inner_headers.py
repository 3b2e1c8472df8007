"""Headers of packages that lie inside of another one, whose CMake looks for them there."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import path_in_package
from ...lazy_regex import regex
from .cmake_project import CMake

BUILT = regex(r"\$<BUILD_INTERFACE:([^$<>]*)>")
PLACE = "/include/"


def inner_headers(cmake: CMake) -> frozenset[str]:
    """Return the headers in packages inside of this one that its own build finds.

    colcon does not build what lies inside of a package, so they can come from no other place.
    """
    inner = frozenset(cmake.package_files.every).difference(cmake.package_files.paths)
    if not inner:
        return inner
    found = (path.removeprefix(place) for place in included(cmake) for path in inner if path.startswith(place))
    offered = (path.partition(PLACE)[2] for place in added(cmake) for path in inner if path.startswith(place))
    return frozenset((*found, *filter(None, offered)))


def included(cmake: CMake) -> Iterator[str]:
    """Yield the folders of the package that the compiler looks in, each with a slash behind it."""
    for call in cmake.named("include_directories", "target_include_directories"):
        for word in call.words:
            built = BUILT.fullmatch(word.text)
            for text in (built[1] if built else word.text).split(";"):
                if path := path_in_package(text, call.folder):
                    yield f"{path}/"


def added(cmake: CMake) -> Iterator[str]:
    """Yield the folders whose CMake file is a part of the package's own, whose targets tell where their headers are."""
    for call in cmake.named("add_subdirectory"):
        if call.words and (path := path_in_package(call.texts[0], call.folder)):
            yield f"{path}/"
