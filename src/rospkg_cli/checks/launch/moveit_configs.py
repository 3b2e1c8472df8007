"""Packages of MoveIt configurations that launch files build parameters of: `MoveItConfigsBuilder('arm')`."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_to_text import text_of
from ...source import Span

BUILDER, ENDING = "MoveItConfigsBuilder", "_moveit_config"


def moveit_configs(file: LaunchFile) -> Iterator[tuple[str, Span]]:
    """Yield the package of each builder: the one that it is given, or that called like the robot.

    (moveit_configs_utils/moveit_configs_builder.py: `package_name or robot_name + "_moveit_config"`)
    """
    for call in file.evaluated.calls if file.evaluated is not None else ():
        if call.callee.rpartition(".")[2] == BUILDER and call.receiver is None and call.rest is None:
            package = call.get("package_name")
            given = package or call.get("robot_name", 0)
            text = text_of(given) if given is not None else None
            if text is not None and text.literal:
                yield text.literal if package is not None else f"{text.literal}{ENDING}", text.span
