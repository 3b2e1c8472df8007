"""Packages whose sources are all for ROS 1, so that their branch for ament can build nothing."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake

CHOOSES = regex(r"\b(?:ament_cmake|catkin)_FOUND\b|\bCATKIN_DEVEL_PREFIX\b|\$ENV\{ROS_VERSION\}")
OF_ROS1 = regex(r"^[ \t]*#[ \t]*include[ \t]*[<\"]ros/ros\.h\b", re.MULTILINE)
OF_ROS2 = regex(r"^[ \t]*#[ \t]*include[ \t]*[<\"]rclcpp", re.MULTILINE)
SOURCES = (".cpp", ".cc", ".cxx")


def is_built_for_ros1(cmake: CMake) -> bool:
    """Return whether CMake chooses between ament and catkin, and all sources are of ROS 1: the branch is a leftover."""
    files = cmake.package_files
    if not any(CHOOSES.search(file.source.text) for file in cmake.files):
        return False
    texts = [files.readable_text(path) for path in files.paths if path.endswith(SOURCES)]
    return bool(texts) and all(OF_ROS1.search(text) and not OF_ROS2.search(text) for text in texts)
