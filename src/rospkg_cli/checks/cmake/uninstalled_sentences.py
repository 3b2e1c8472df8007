"""Messages on targets that are built and not installed (CMK103)."""

from __future__ import annotations

from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.uninstalled_target import UninstalledTarget
from .doubled_names import DoubledName

USERS = {
    "component": "the component `{}`",
    "exporter": "those who use the package, as `ament_export_libraries` promises it,",
    "linked target": "`{}`, which is linked with it and is installed,",
    "exported target": "`{}` is exported and",
    "parameter library": "who links it, as the other parameter libraries can be,",
}


def uninstalled(package: CMakePackage, forgotten: UninstalledTarget, *, why_idle: str = "") -> str:
    """Return the sentence for a target; `why_idle` says of a library why what is linked with it may not need it."""
    name = package.cmake.quoted(forgotten.target.word)
    user = USERS[forgotten.needed_by.user].format(forgotten.needed_by.name) if forgotten.needed_by else ""
    if forgotten.stops:
        return (
            f"{user} links {name}, which is not: CMake stops with "
            '"… requires target … that is not in any export set"; install it with the same EXPORT'
        )
    if forgotten.target.is_executable:
        return (
            f"the executable {name} is built and not installed: `ros2 run {package.facts.name} "
            f"{forgotten.target.name}` does not find it; install it into lib/${{PROJECT_NAME}}"
        )
    if why_idle:
        start = f"the library {name} is built and not installed"
        return f"{start}: {user} {why_idle}; install it into lib, or don't link it"
    return f"the library {name} is built and not installed: {user} can't load it; install it into lib"


def said_twice(each: DoubledName) -> str:
    name = each.target.name
    return (
        f"`{each.word.text}` is installed twice, and the library `{name}`, which is made before, is not: "
        f"what loads `{name}` finds no file; write `{name}` here"
    )
