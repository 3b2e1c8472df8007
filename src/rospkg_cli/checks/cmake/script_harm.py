"""How bad it is that a script can't be executed where it is installed (CMK105): who is shown to run it."""

from __future__ import annotations

from typing import Literal

from .installed_scripts import BrokenScript, InstalledScripts
from .left_out_nodes import is_node
from .swept_scripts import is_swept_along

Harm = Literal["error", "warning", "info"]
ONLY_THE_BIT = ("no bit", "directory, no bit")
"""What a copy of the repository may have lost, such as an archive or a share of Windows."""
MILD = ("directory", "neither")
"""What is a lesser fault beside scripts that are installed as programs."""


def harm(scripts: InstalledScripts, script: BrokenScript) -> Harm:
    """Return an error where the script is started, or where `ros2 run` never finds a node, whoever builds it."""
    if scripts.is_module(script) or is_swept_along(scripts, script) or may_be_lost(scripts, script):
        return "info"
    is_started = scripts.is_wanted(script.copy.source)
    is_mild = script.wrong == "no bit" or (script.wrong in MILD and scripts.uses_programs) or scripts.is_tool(script)
    return "warning" if is_mild or not (is_started or is_program(scripts, script)) else "error"


def may_be_lost(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a script only lacks its bit here, and nothing of the repository starts it."""
    return script.wrong in ONLY_THE_BIT and not scripts.is_wanted(script.copy.source)


def is_program(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a rule makes a script no program by its own words, and it is a node, or has no first line."""
    if script.wrong == "no shebang":
        return True
    return script.wrong in ("files", "directory") and is_node(script.copy.source, scripts.package.cmake.package_files)
