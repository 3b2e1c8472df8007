"""Empty variables with which nothing is lost (CMK115)."""

from __future__ import annotations

from ...package.cmake.cmake_project import CMake
from .needed_places import NeededPlaces
from .package_variables import OF_PACKAGE
from .unset_variable import ADDING, UnsetVariable

FLAGS = ("CMAKE_CXX_FLAGS", "CMAKE_C_FLAGS")
"""Variables that are mostly empty, unless a user sets them."""


def why_harmless(cmake: CMake, each: UnsetVariable) -> str:
    """Return why nothing is lost with a variable that nothing sets, as the end of a sentence; "" where it may be."""
    if is_consistent(cmake, each):
        return "; the target is called so everywhere"
    why = NeededPlaces(cmake).why_unread(each.call)
    return f"; {why}" if why else ""


def is_consistent(cmake: CMake, each: UnsetVariable) -> bool:
    """Return whether a target has the name that is left without the variable, and has it in all commands.

    Where a command writes the name with the intended variable, it names a target that does not exist.
    """
    made = (cmake.source_text(target.word).strip('"') for target in cmake.targets)
    if not each.after or not each.near or each.before not in made:
        return False
    intended = each.before.replace(f"${{{each.name}}}", f"${{{each.near}}}")
    commands = (command for file in cmake.files for command in file.syntax.commands)
    return not any(argument.text == intended for command in commands for argument in command.arguments)


def is_package_used_anyway(cmake: CMake, each: UnsetVariable) -> bool:
    """Return whether targets get the package of a variable in another way: by its name, or the intended variable."""
    found = OF_PACKAGE.fullmatch(each.near)
    if found is None or not each.is_of_same_package or each.call.name not in ADDING:
        return False
    if found[2].startswith("INCLUDE"):
        return True  # where the folder is needed, the build fails
    given = {text for call in cmake.named("ament_target_dependencies") for text in call.texts[1:]}
    linked = (text for call in cmake.named("target_link_libraries") for text in call.texts[1:])
    is_linked = found[1] in given or any(text.startswith(f"{found[1]}::") for text in linked)
    adding = (call for call in cmake.named(*ADDING) if call is not each.call)
    arguments = (argument.text for call in adding for argument in call.command.arguments[1:])
    return is_linked or any(f"${{{each.near}}}" in text for text in arguments)


def keeps_no_flags(cmake: CMake, each: UnsetVariable) -> bool:
    """Return whether `set` should keep flags, none of which the package has set before."""
    sets = (call for call in cmake.named("set") if call.texts[:1] == (each.near,))
    is_kept = each.call.name == "set" and each.near in FLAGS
    return is_kept and next(sets, each.call).command is each.call.command
