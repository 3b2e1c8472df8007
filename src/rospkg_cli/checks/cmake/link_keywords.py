"""Whether targets are linked with PUBLIC, PRIVATE or INTERFACE, or without: CMake refuses to mix the two."""

from __future__ import annotations

from typing import Literal

from ...package.cmake.cmake_project import CMake

KEYWORDS = ("PUBLIC", "PRIVATE", "INTERFACE")
LINK_KEYWORDS = (*KEYWORDS, "LINK_PUBLIC", "LINK_PRIVATE", "LINK_INTERFACE_LIBRARIES")
LINK_PLAINLY = ("ament_add_gtest", "ament_add_gmock", "ament_add_gtest_executable", "ament_add_gmock_executable",
                "ament_add_google_benchmark", "ament_auto_add_gtest", "ament_auto_add_library",
                "ament_auto_add_executable", "ament_add_ros_isolated_gtest",
                "ament_add_ros_isolated_gmock")  # fmt: skip
"""Commands that link their target without a keyword: CMake then refuses keywords in other calls."""

Signature = Literal["plain", "keyword"]


def signatures(cmake: CMake) -> dict[str, Signature]:
    """Return how targets are linked by `target_link_libraries()` or by the command that makes them."""
    found: dict[str, Signature] = {}
    for call in cmake.named("target_link_libraries"):
        if len(call.texts) > 1:
            found.setdefault(call.texts[0], "keyword" if call.texts[1] in LINK_KEYWORDS else "plain")
    plain = [target.name for target in cmake.targets if target.call.name in LINK_PLAINLY]
    return {**found, **dict.fromkeys(plain, "plain")}
