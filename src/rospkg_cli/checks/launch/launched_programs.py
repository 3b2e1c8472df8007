"""Python files among launch files that are programs: nodes and tools that are kept there."""

from __future__ import annotations

from ...package.launch.launch_evaluator import ENTRIES
from ...package.launch.launch_file import LaunchFile

LAUNCH = "launch"
"""What the packages of launch begin with: `launch_ros`, `launch_testing`, `launch_param_builder`."""


def is_program(file: LaunchFile) -> bool:
    """Return whether a Python file among launch files is a program: it describes no launch, and imports nothing of it.

    A file that takes all names of a module may have its launch description from there.
    """
    python = file.python
    if python is None or python.star_imports or not python.definitions.keys().isdisjoint(ENTRIES):
        return False
    return not any(each.module.startswith(LAUNCH) for each in file.imports)
