"""What REP-127, REP-140 and REP-149 say of package.xml: tags, their order, names, build types."""

from __future__ import annotations

import re

DEPENDENCY_TAGS = (
    "buildtool_depend",
    "buildtool_export_depend",
    "build_depend",
    "build_export_depend",
    "depend",
    "exec_depend",
    "run_depend",
    "test_depend",
    "doc_depend",
    "conflict",
    "replace",
)

ORDER = (
    "name",
    "version",
    "description",
    "maintainer",
    "license",
    "url",
    "author",
    DEPENDENCY_TAGS,
    "group_depend",
    "member_of_group",
    "export",
)
"""The order of the schemas: what stands together in a tuple may stand in any order."""

BUILD_TYPES = ("ament_python", "ament_cmake", "cmake", "catkin")
"""The build types that we know how to check."""

OTHER_BUILD_TYPES = ("ament_cargo", "ament_gradle", "ament_nodejs", "bazel", "meson")
"""Build types of colcon's extensions."""

PACKAGE_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
"""REP-144 and the schemas: lower case, no `__`, no `_` at the end."""

VERSION = re.compile(r"(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)")


def place_of(tag: str) -> int:
    """Return a tag's place in the schema's order; an unknown tag comes last."""
    for place, each in enumerate(ORDER):
        if tag == each or (isinstance(each, tuple) and tag in each):
            return place
    return len(ORDER)
