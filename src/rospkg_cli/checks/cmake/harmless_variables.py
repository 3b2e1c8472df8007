"""Variables that are empty, and with which nothing is lost: the end of a sentence says why (CMK115)."""

from __future__ import annotations

from ...package.cmake.cmake_project import CMake
from .needed_places import NeededPlaces
from .unset_variables import UnsetVariable


def why_harmless(cmake: CMake, each: UnsetVariable) -> str:
    """Return why nothing is lost with a variable that nothing sets; "" where something may be."""
    if is_consistent(cmake, each):
        return "; the target is called so everywhere"
    why = NeededPlaces(cmake).why_unread(each.call)
    return f"; {why}" if why else ""


def is_consistent(cmake: CMake, each: UnsetVariable) -> bool:
    """Return whether a target is made under the name that is left without the variable, and has it everywhere.

    Where anything is written with the intended variable, that is missed there.
    """
    made = (cmake.source_text(target.word).strip('"') for target in cmake.targets)
    if not each.after or not each.near or each.before not in made:
        return False
    meant = each.before.replace(f"${{{each.name}}}", f"${{{each.near}}}")
    commands = (command for file in cmake.files for command in file.syntax.commands)
    return not any(argument.text == meant for command in commands for argument in command.arguments)
