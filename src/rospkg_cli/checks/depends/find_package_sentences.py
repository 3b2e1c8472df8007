"""What is said of packages that CMake requires and of commands that it does not know (DEP104)."""

from __future__ import annotations

from .undeclared_find_package import UndeclaredFindPackage
from .undeclared_test_commands import UndeclaredTestCommand


def unknown_command(each: UndeclaredTestCommand) -> str:
    start = f"`{each.call.name}` comes with `{each.package}`, which is neither found nor declared"
    if each.may_be_brought:
        stops = "it is known only if another package finds it"
    else:
        stops = 'CMake stops with "Unknown CMake command"'
    return f"{start}: {stops}; find it, and declare it as `<test_depend>`"


def not_installable(missing: UndeclaredFindPackage) -> str:
    return (
        f"CMake requires `{missing.found.name}`, and package.xml does not declare it: rosdep installs nothing for "
        f"`{missing.names[0]}` on supported distributions; declare the vendor package that brings it"
    )
