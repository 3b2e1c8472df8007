"""Components (rclcpp_components), as CMake commands register them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass

OF_ONE_NODE = ("PLUGIN", "EXECUTABLE", "EXECUTOR")
"""Keywords of `rclcpp_components_register_node`, which `…_nodes` would read as names of classes."""


@dataclass(frozen=True)
class Component:
    target: Word
    plugin: Word
    """`namespace::Class`"""
    executable: Word | None
    call: EvaluatedCommand


def components_of(calls: Iterable[EvaluatedCommand]) -> Iterator[Component]:
    """Yield the components that some calls register, in order."""
    for call in calls:
        if call.name == "rclcpp_components_register_node" and call.words:
            singles = ("PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX")
            _, values, _ = flags_and_values(call.words[1:], (), singles, ())
            executable = next(iter(values.get("EXECUTABLE", [])), None)
            for plugin in values.get("PLUGIN", []):
                yield Component(call.words[0], plugin, executable, call)
        elif call.name == "rclcpp_components_register_nodes" and call.words:
            _, _, plugins = flags_and_values(call.words[1:], ("PLUGIN",), ("RESOURCE_INDEX", *OF_ONE_NODE[1:]), ())
            for plugin in plugins:
                yield Component(call.words[0], plugin, None, call)
