"""Exports of plugin descriptions without the macro of pluginlib: by ament_index itself, or by another macro."""

from __future__ import annotations

import posixpath

from ..cmake.cmake_project import CMake

REGISTER = "ament_index_register_resource"
KIND = "__pluginlib__plugin"
"""How pluginlib calls the entry of the index, behind the package of the base class."""


def is_registered(cmake: CMake) -> bool:
    """Return whether CMake writes an entry of the index for plugins itself, whose content lists the descriptions."""
    calls = cmake.named(REGISTER)
    return any(not call.words or not call.words[0].is_known or KIND in call.words[0].text for call in calls)


def may_export(cmake: CMake, file: str) -> bool:
    """Return whether CMake registers a description in another way, or passes it to a macro of another package."""
    from ..cmake.foreign_commands import foreign_commands  # few descriptions are not exported by pluginlib's call

    if is_registered(cmake):
        return True
    name, foreign = posixpath.basename(file), {call.name for call in foreign_commands(cmake)}
    calls = (call for call in cmake.calls if call.name in foreign)
    return any(posixpath.basename(word.text) == name for call in calls for word in call.words)
