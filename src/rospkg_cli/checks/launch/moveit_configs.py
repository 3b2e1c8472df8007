"""Packages of MoveIt configurations that launch files build parameters of: `MoveItConfigsBuilder('arm')`."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.launch_file import LaunchFile
from ...package.launch.moveit_builder import builder_package
from ...source import Span


def moveit_configs(file: LaunchFile) -> Iterator[tuple[str, Span]]:
    """Yield the package of each builder: the one that it is given, or that called like the robot."""
    for call in file.evaluated.calls if file.evaluated is not None else ():
        package = builder_package(call)
        if package is not None:
            yield package.literal or "", package.span
