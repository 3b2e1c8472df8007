"""What happens to a launch on a machine that lacks a package of it."""

from __future__ import annotations

from .package_reference import OF_DESKTOP, PackageReference


def ends_with(use: PackageReference, name: str, where: str) -> str:
    """Return what happens `where` a package is missing."""
    if use.only_with:
        return f"with `{use.only_with}` it must be there"
    match use.fails:
        case "launch":
            ends = f"the launch stops with \"package '{name}' not found\""
        case "import":
            ends = "the launch stops with ModuleNotFoundError"
        case "program":
            ends = "the launch stops: the program is not found"
        case "component":
            ends = "the container logs an error and runs without it"
        case "controller":
            ends = "the controller manager can't load it"
        case "command":
            ends = "`ros2` does not know the command"
        case "process":
            ends = "the process does not start"
            ends += ", unless Ubuntu's desktop is there" if name in OF_DESKTOP else ""
    return f"{where} {ends}"
