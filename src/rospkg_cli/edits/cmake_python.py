"""Edits that install a Python package with CMake."""

from __future__ import annotations

from ..finding import Edit
from ..package.cmake.cmake_project import CMake
from .cmake_commands import add_after
from .cmake_rule_place import add_rule

FINDER = "ament_cmake_python"


def python_install(name: str, folder: str, shown: str = "") -> str:
    """Return the command that installs a Python package in a folder; "" for one called like it."""
    place = "" if folder in (name, "") else f" PACKAGE_DIR {folder}"
    return f"ament_python_install_package({shown or name}{place})"


def install_python_package(cmake: CMake, name: str, folder: str = "") -> tuple[Edit, ...]:
    """Call ament_python_install_package, and look for what defines it, where nothing does so yet."""
    call = add_rule(cmake, python_install(name, folder, "${PROJECT_NAME}" if name == cmake.project_name else name))
    if any(each.name == FINDER for each in cmake.packages):
        return (call,)
    found = [each.call for each in cmake.packages if cmake.root.is_top(each.call.command) and not each.call.maybe]
    anchor = next((call for call in found if call.texts[0] == "ament_cmake"), found[-1] if found else None)
    if anchor is None:
        return (call,)
    return (add_after(cmake.root, anchor.command, f"find_package({FINDER} REQUIRED)"), call)
