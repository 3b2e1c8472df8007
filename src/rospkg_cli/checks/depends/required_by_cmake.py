"""What CMake requires by its name, so that it stops before the compiler misses a header."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.cmake.cmake_project import CMake

ASKS = ("pkg_check_modules", "pkg_search_module")
VERSION = ("<", ">", "=")


def required_packages(cmake: CMake) -> Iterator[str]:
    """Yield the packages that CMake certainly requires."""
    return (found.name for found in cmake.packages if found.is_required and not found.call.maybe)


def required_modules(cmake: CMake) -> Iterator[str]:
    """Yield the modules of pkg-config that CMake certainly requires."""
    for call in cmake.named(*ASKS):
        if "REQUIRED" in call.texts and not call.maybe:
            yield from map(without_version, call.texts[1:])


def without_version(module: str) -> str:
    """Return a module of pkg-config without its limit: `libcurl` of `libcurl>=7`."""
    return min((module.partition(sign)[0].strip() for sign in VERSION), key=len)
