"""The headers that what a package compiles includes, for the packages that have them."""

from __future__ import annotations

from ..files import ReaderInput
from ..languages.cpp.file import CppFile
from ..lazy_regex import regex
from .cmake.cmake_project import CMake
from .cmake.inner_headers import inner_headers
from .params.node_sources import sources

ELSEWHERE = regex(r"\.\./|/\.\.|CMAKE_SOURCE_DIR\}/src|\$ENV\{|add_subdirectory|link_directories")
"""What a CMake file holds that may reach into the source folder of another package."""


def included_headers(reading: ReaderInput) -> frozenset[str]:
    """Return what the sources of targets include by a path with a folder; nothing where CMake looks elsewhere.

    Left out are tests, and what is included under a condition.
    """
    cmake = reading.parts(CMake).only
    if cmake is None or any(ELSEWHERE.search(file.source.text) for file in cmake.files):
        return frozenset()
    targets = (target for target in cmake.targets if not (target.call.testing or target.call.maybe))
    compiled = {path for target in targets for path in sources(cmake, target)}
    files = (file for file in reading.parts(CppFile).good if file.path in compiled)
    found = frozenset(
        each.path for file in files for each in file.includes if "/" in each.path and not each.is_conditional
    )
    return found - inner_headers(cmake)
