"""Messages on scripts that can't be executed where they are installed (CMK105)."""

from __future__ import annotations

from collections.abc import Sequence

from ..enumeration import in_ticks
from .broken_scripts import BrokenScript
from .installed_scripts import InstalledScripts

FEW = 3
"""From this many on, only the first script is named."""
LOST = " (nothing here starts it, and a copy of files may lose the bit)"
"""What is added where only the bit of a script is missing."""
KEPT = " (nothing here starts it, and its name or its own text says that it is not used)"
BY_PATH = " (the pages and scripts here start it by its path alone, with Python)"
SHEBANG = "#!/usr/bin/env python3"


def title(script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    these = named(script, others)
    match script.wrong:
        case "files":
            return "install with PROGRAMS"
        case "no shebang":
            return f"begin {these} with `{SHEBANG}`"
        case "directory":
            return "add USE_SOURCE_PERMISSIONS"
        case "neither":
            return f"make {these} executable, and add USE_SOURCE_PERMISSIONS"
        case _:
            return f"make {these} executable"


def named(script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    """Return the scripts by name, where they are few."""
    if len(others) < FEW:
        return in_ticks(each.copy.source for each in (script, *others))
    return f"`{script.copy.source}` and {len(others)} more"


def message(scripts: InstalledScripts, script: BrokenScript, others: Sequence[BrokenScript]) -> str:
    path, name = script.copy.source, script.copy.destination.rpartition("/")[2]
    run = f"`ros2 run {scripts.package.facts.name} {name}`"
    these, are, them = named(script, others), "are" if others else "is", "them" if others else "it"
    chmod = "`chmod +x` them" if others else f"`chmod +x {path}`"
    match script.wrong:
        case "files":
            return (
                f"{these} {are} installed with FILES, which makes {them} not executable: {run} does not find it; "
                "use PROGRAMS"
            )
        case "no shebang":
            begin = "do not begin" if others else "does not begin"
            return f'{these} {begin} with `#!`: {run} ends with "Exec format error"; write `{SHEBANG}`'
        case "directory":
            return f"the executable bit of {these} is not installed: {run} does not find it; add USE_SOURCE_PERMISSIONS"
        case "neither":
            return (
                f"{these} {are} not executable, nor would the bit be installed: {run} does not find it; {chmod} "
                "(`git update-index --chmod=+x`), and add USE_SOURCE_PERMISSIONS"
            )
        case "directory, no bit":
            return f"{these} {are} not executable: {run} does not find it; {chmod}"
        case _:
            return (
                f"{these} {are} not executable: after `colcon build --symlink-install` {run} does not find it; {chmod}"
            )
