"""Whether a linker runs for a target: for a static library none does, until something is linked with it."""

from __future__ import annotations

from ...languages.cmake.targets import Target
from ...package.cmake.cmake_project import CMake
from ...package.cmake.target_links import TargetLinks

OF_NO_KIND = frozenset({"add_library", "ament_auto_add_library", "cuda_add_library"})
"""Commands whose libraries are static where nothing else is said."""
SWITCH = "BUILD_SHARED_LIBS"
OFF = frozenset({"OFF", "FALSE", "NO", "0"})


def runs_linker(cmake: CMake, name: str, seen: frozenset[str] = frozenset()) -> bool:
    """Return whether a linker gets what a target is linked with: for it, or for one that is linked with it."""
    target = cmake.target(name)
    if target is None or not is_static(cmake, target):
        return True
    users = {link.target for link in TargetLinks(cmake).with_word(name) if not link.package} - seen - {name}
    return any(runs_linker(cmake, user, seen | {name}) for user in users)


def is_static(cmake: CMake, target: Target) -> bool:
    """Return whether a library is static, of objects or of headers, or is of no kind and nothing makes it shared."""
    if not target.is_library or target.options & {"SHARED", "MODULE"}:
        return False
    if target.options & {"STATIC", "OBJECT", "INTERFACE"}:
        return True
    return target.call.name in OF_NO_KIND and not TargetLinks(cmake).shared(target) and not is_shared_by_default(cmake)


def is_shared_by_default(cmake: CMake) -> bool:
    calls = (call for call in cmake.named("set", "option") if call.texts[:1] == (SWITCH,))
    return any(OFF.isdisjoint(call.texts[1:]) for call in calls)
