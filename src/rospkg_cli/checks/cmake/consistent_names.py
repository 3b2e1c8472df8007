"""Targets that have the name with an empty variable wherever they are named: nothing is lost by it (CMK115)."""

from __future__ import annotations

from ...package.cmake.cmake_project import CMake
from .unset_variables import UnsetVariable


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
