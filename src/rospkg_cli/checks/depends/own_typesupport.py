"""What a target gets with the interfaces of its own package: the packages that these depend on."""

from __future__ import annotations

from collections.abc import Sequence

from ...languages.cmake.values import UNKNOWN
from ...package.cmake.cmake_project import CMake
from ...package.cmake.target_links import TargetLink

MARK = "__rosidl_"
"""Part of the name of each library that rosidl makes of a package's interfaces."""
ALWAYS = frozenset({"rosidl_runtime_cpp", "rosidl_typesupport_interface"})
"""What generated headers of C++ include themselves."""
OF_KIND = {".srv": "service_msgs", ".action": "action_msgs"}


def with_own_interfaces(cmake: CMake, target: str, links: Sequence[TargetLink]) -> frozenset[str] | None:
    """Return the packages that a target gets with the interfaces of its package; None where they are unknown.

    `rosidl_target_interfaces()` and a link with one of their libraries hand on what `rosidl_generate_interfaces()`
    is given as DEPENDENCIES.
    """
    is_given = any(call.texts[:1] == (target,) for call in cmake.named("rosidl_target_interfaces"))
    if not is_given and not any(MARK in link.word.text for link in links):
        return frozenset()
    found = set(ALWAYS)
    for made in cmake.interface_targets:
        if any(UNKNOWN in word.text for word in (*made.dependencies, *made.files)):
            return None
        found.update(word.text for word in made.dependencies)
        found.update(of for end, of in OF_KIND.items() if any(word.text.endswith(end) for word in made.files))
    return frozenset(found)
