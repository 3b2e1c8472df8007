"""Controllers of ros2_controllers that a launch file has loaded: each is called like the package that holds it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...ros.read_table import rows
from ...source import Span

MANAGER, COLLECTION = "controller_manager", "ros2_controllers"
LOADS = ("ros2", "control", "load_controller")


def spawned_controllers(file: LaunchFile) -> Iterator[tuple[str, Span]]:
    """Yield the names that a spawner of controller_manager, or `ros2 control load_controller`, is given.

    A name is the user's choice; one of a well-known package is that of the controller in it.
    """
    for node in file.nodes:
        package = node.package.literal if node.package else None
        program = node.executable.literal if node.executable else None
        if package == MANAGER and program and program.startswith("spawner"):
            yield from controllers_among(node.arguments)
    for command in file.commands:
        if tuple(word.literal for word in command.words[: len(LOADS)]) == LOADS:
            yield from controllers_among(command.words[len(LOADS) :])


def controllers_among(words: Iterable[LaunchText]) -> Iterator[tuple[str, Span]]:
    known = rows("metapackages.txt")[COLLECTION]
    for word in words:
        for name in (word.literal or "").split():
            if name in known:
                yield name, word.span
