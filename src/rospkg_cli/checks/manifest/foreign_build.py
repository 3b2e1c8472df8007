"""Packages that another build system makes: a macro of a file that is elsewhere gets their name, and ament nothing."""

from __future__ import annotations

from ...lazy_regex import regex
from ...package.cmake.foreign_commands import foreign_commands
from .manifest_and_cmake import ManifestAndCMake

OF_ROS = regex(r"install|(?:ament|rosidl|rclcpp_components|pluginlib|generate_parameter|autoware)_\w+")
"""Commands that make, install or register something of ROS 2."""


def foreign_maker(package: ManifestAndCMake) -> str:
    """Return the macro that makes the package as another build system wants it; "" where there is none.

    `find_package(ament_cmake)` alone, for the paths of messages, makes no package of ROS 2.
    """
    cmake = package.cmake
    if cmake is None or not cmake.is_complete or package.ends_a_package or not cmake.reads_unknown_files:
        return ""
    declares = any(each.name.startswith("ament_") for each in package.manifest.dependencies)
    if declares or any(OF_ROS.fullmatch(call.name) for call in cmake.calls):
        return ""
    names = {cmake.project_name, package.manifest.name}
    return next((call.name for call in foreign_commands(cmake) if call.texts[0] in names), "")
