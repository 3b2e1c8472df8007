"""What REP-127, REP-140 and REP-149 say of package.xml: tags, their order, names, build types."""

from __future__ import annotations

import re

from ..lazy_regex import regex

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

RELATIONS = ("conflict", "replace")
"""Tags among them that make no package a dependency."""

NOT_ORDERED = ("doc_depend", "conflict", "replace")
"""Dependencies that colcon does not wait for."""

RUNS = frozenset({"depend", "exec_depend", "run_depend", "build_export_depend", "buildtool_export_depend"})
"""Tags whose packages are there when a package runs; so are those of the tags for others, which build with it."""

BUILDS = frozenset({"depend", "build_depend", "buildtool_depend", "buildtool_export_depend"})
"""Tags whose packages are there when a package is built."""

EXPORTED = frozenset({"depend", "build_export_depend", "buildtool_export_depend"})
"""Tags whose packages are there for whoever builds against the one that declares them."""

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
"""The order of the schemas; the tags of a tuple may be in any order."""

REQUIRED = ("name", "version", "description", "maintainer", "license")
"""What every package.xml must have."""

ONCE = ("name", "version", "description", "export")
"""Tags that may occur once; the others may be repeated."""

CONDITIONAL_TAGS = (*DEPENDENCY_TAGS, "group_depend", "member_of_group")
"""Children of <package> that may carry a condition in format 3; in <export> it is build_type."""

PART_OF_DEPEND = ("build_depend", "build_export_depend", "exec_depend")
"""What <depend> means all at once."""

FORMATS = (1, 2, 3)

NEW_IN: dict[int, tuple[str, ...]] = {
    2: ("build_export_depend", "buildtool_export_depend", "depend", "exec_depend", "doc_depend"),
    3: ("group_depend", "member_of_group"),
}
"""The tags that a format added to the one before; format 2 dropped run_depend."""

ATTRIBUTES_OF_3 = {"version": "compatibility", "license": "file"} | dict.fromkeys(DEPENDENCY_TAGS, "condition")
"""The attribute that format 3 added to a tag."""

INSIDE_EXPORT = ("build_type", "metapackage", "architecture_independent", "deprecated", "message_generator")
"""Tags that REP-149 knows inside <export>, and nowhere else."""

VERSION_LIMITS = ("version_lt", "version_lte", "version_eq", "version_gte", "version_gt")

URL_TYPES = ("website", "bugtracker", "repository")

URL_MEANT = {
    **dict.fromkeys(("home", "homepage", "wiki", "web", "doc", "docs", "documentation", "url"), "website"),
    **dict.fromkeys(("issues", "issue", "bug", "bugs", "issuetracker", "issue_tracker", "tracker"), "bugtracker"),
    **dict.fromkeys(("repo", "source", "sources", "github", "git", "code", "vcs", "scm", "sourcecode"), "repository"),
    "development": "repository",
}
"""What people write for them."""

BUILD_TYPES = ("ament_python", "ament_cmake", "cmake", "catkin")
"""The build types that we know how to check."""

OTHER_BUILD_TYPES = ("ament_cargo", "ament_gradle", "ament_nodejs", "bazel", "meson")
"""Build types of colcon's extensions."""

BUILD_FILES = {"ament_python": "setup.py", "ament_cmake": "CMakeLists.txt", "cmake": "CMakeLists.txt"}
"""What each build type is built by."""

PACKAGE_NAME = regex(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
"""REP-144 and the schemas: lower case, no `__`, no `_` at the end."""

NUMBER = "(0|[1-9][0-9]*)"
VERSION = regex(rf"{NUMBER}\.{NUMBER}\.{NUMBER}")
VERSION_LIMIT = regex(rf"{NUMBER}(\.{NUMBER}(\.{NUMBER})?)?")

EMAIL = regex(r"[\w%+-]+(\.[\w%+-]+)*@([A-Za-z0-9%-]+\.)+[A-Za-z]{2,}", re.ASCII)
"""What the schemas and every release tool take for an e-mail address."""

ENVIRONMENT = ("ROS_VERSION", "ROS_DISTRO", "ROS_PYTHON_VERSION", "DISABLE_GROUPS_WORKAROUND")
"""The variables that conditions may ask for: those of a ROS environment, and the one that colcon sets."""

SCHEMA_URL = "http://download.ros.org/schema/package_format{}.xsd"
XML_MODEL = f'<?xml-model href="{SCHEMA_URL}" schematypens="http://www.w3.org/2001/XMLSchema"?>'


def place_of(tag: str) -> int:
    """Return a tag's place in the schema's order; an unknown tag comes last."""
    for place, each in enumerate(ORDER):
        if tag == each or (isinstance(each, tuple) and tag in each):
            return place
    return len(ORDER)


BUILD_TOOLS = regex(
    r"ament_cmake.*|ament_lint.*|rosidl_(cmake|default_generators|generator_.*)|.*_cmake(_module)?|cmake"
)
"""Packages that take part in a build and are no part of what is built."""

ONLY_ROS_2 = regex(
    r"(ament|rcl|rclc|rclcpp|rclpy|rmw|rosidl|launch|nav2|ros_gz)(_.*)?|rcutils|rcpputils|rosbag2.*|\w*ros2\w*"
    r"|(sensor_msgs|tf2_ros)_py"
)
"""Packages of which no distribution of ROS 1 has one of that name."""


def is_buildtool(name: str) -> bool:
    return BUILD_TOOLS.fullmatch(name) is not None
