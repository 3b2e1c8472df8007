"""How bad it is that a script can't be executed where it is installed (CMK105): what starts it."""

from __future__ import annotations

from typing import Literal

from ..repository.path_starts import is_started_by_path_alone
from ..repository.spare_files import is_spare
from .broken_scripts import BrokenScript, is_module, is_tool
from .installed_scripts import InstalledScripts
from .left_out_nodes import is_node
from .script_sentences import BY_PATH, KEPT, LOST
from .scripts_of_folders import comes_with_folder

Harm = Literal["error", "warning", "info"]
ONLY_THE_BIT = ("no bit", "directory, no bit")
"""What a copy of the repository may have lost: an archive, or a folder shared with Windows."""
MILD = ("directory", "neither")
"""What is a lesser fault where other scripts are installed with PROGRAMS."""


def harm(scripts: InstalledScripts, script: BrokenScript) -> Harm:
    """Return "error" where the script is started, or is a node that `ros2 run` never finds; else what is milder."""
    if is_module(scripts, script) or comes_with_folder(scripts, script) or why_mild(scripts, script):
        return "info"
    is_started = scripts.starts.is_wanted(script.copy.source)
    is_mild = script.wrong == "no bit" or (script.wrong in MILD and scripts.uses_programs) or is_tool(scripts, script)
    return "warning" if is_mild or not (is_started or is_program(scripts, script)) else "error"


def why_mild(scripts: InstalledScripts, script: BrokenScript) -> str:
    """Return what the message adds for a script that nothing here starts as a program; "" for others."""
    path, files = script.copy.source, scripts.package.cmake.package_files
    if scripts.starts.is_wanted(path):
        return ""
    if script.wrong in ONLY_THE_BIT:
        return LOST
    if is_spare(files, path) and not scripts.starts.is_run(path):
        return KEPT
    return BY_PATH if is_started_by_path_alone(files, scripts.package.facts.name, path) else ""


def is_program(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a script is a node whose install rule makes it not executable, or has no `#!` line."""
    if script.wrong == "no shebang":
        return True
    return script.wrong in ("files", "directory") and is_node(script.copy.source, scripts.package.cmake.package_files)
