"""Libraries whose headers lie in a folder of their own, and that CMake never looks for (DEP107)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from .included_packages import IncludedPackage
from .undeclared_includes import IncludeDependencies

WORDS = {"PCL": "pcl", "OpenCV": "opencv4?", "Eigen3": "eigen3?"}
"""Patterns for the names of libraries with an own include directory (`/usr/include/eigen3`), by CMake's name."""
OF_ROS = "ros|conversions|msgs"
"""What packages of ROS are called behind the name of a library: `pcl_ros` is none that finds PCL for its users."""


def unfound_libraries(includes: IncludeDependencies) -> Iterator[IncludedPackage]:
    """Yield the libraries that are declared and included, and of which no CMake file has a word.

    Commands of ament find no rosdep key: what is declared as `libpcl-all-dev` comes with another package.
    """
    cmake = includes.cmake
    if not includes.declared.is_checked or not cmake.is_complete or cmake.reads_unknown_files:
        return
    text = "".join(file.source.text for file in cmake.files)
    for each in includes.packages():
        word = WORDS.get(each.cmake) if each.role == "run" and includes.is_declared(each) else None
        if word is not None and not includes.including.are_idle(each) and not includes.including.are_passed_on(each):
            written = rf"(?<![a-z_]){word}(?![a-z])(?!_(?:{OF_ROS})\b)"
            if not re.search(written, text, re.IGNORECASE):
                yield each
