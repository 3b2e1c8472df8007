"""What DEP201 says of a use, and of what happens without it."""

from __future__ import annotations

from .dependency_kinds import WrongKind


def usage(each: WrongKind) -> str:
    """Return what uses a dependency, as a clause."""
    match each.use.need:
        case "import":
            return f"installed code imports `{each.use.what}`"
        case "launch":
            return "this launch file needs it"
        case "include":
            return f"`{each.use.what}` is included"
        case "find":
            return f"CMake requires `{each.use.what}`"
        case "interface":
            return f"an interface has `{each.use.what}` in it" if each.use.what else "interfaces are generated with it"
        case "link":
            return f"`{each.use.what}`, which is installed, is linked with it"


def ending(each: WrongKind) -> str:
    """Return what happens where a dependency is not there at the time of its use, as a clause."""
    match each.use.need:
        case "import":
            return "where only a release is installed, ModuleNotFoundError is raised"
        case "launch" | "find":
            return each.use.ends
        case "include":
            return 'on the build farm the build ends with "No such file or directory"'
        case "interface" if not each.use.what:
            return "where only a release is installed, packages that look for this one stop, as it is not found"
        case "interface":
            return "where only a release is installed, the generated code can't be loaded"
        case "link":
            return 'where only what runs is installed, it ends with "cannot open shared object file"'
