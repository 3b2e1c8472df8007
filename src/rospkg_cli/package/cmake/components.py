"""Components (rclcpp_components) and generated interfaces, as CMake commands declare them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.values import Word, as_value
from ...light_dataclasses import dataclass

OF_ONE_NODE = ("PLUGIN", "EXECUTABLE", "EXECUTOR")
"""Keywords of `rclcpp_components_register_node`, which `…_nodes` takes for names of classes."""


@dataclass(frozen=True)
class Component:
    target: Word
    plugin: Word
    """`namespace::Class`"""
    executable: Word | None
    call: EvaluatedCommand


@dataclass(frozen=True)
class InterfaceTarget:
    """`rosidl_generate_interfaces(target files… DEPENDENCIES packages…)`"""

    target: Word
    files: tuple[Word, ...]
    """`msg/Name.msg`, relative to the folder of the call; an absolute one is `base:msg/Name.msg`."""
    dependencies: tuple[Word, ...]
    skip_install: bool
    call: EvaluatedCommand

    def path_of(self, word: Word) -> str | None:
        """Return the path of a listed file, relative to the package; None where it is elsewhere or unknown.

        An absolute one has a `:` where its own part begins.
        """
        text = word.text
        if text.startswith("/") and ":" in text:
            base, _, own = text.rpartition(":")
            text = f"{base}/{own}"
        return path_in_package(text, self.call.folder) if word.is_known else None


def components_of(calls: Iterable[EvaluatedCommand]) -> Iterator[Component]:
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


def interface_targets_of(calls: Iterable[EvaluatedCommand]) -> Iterator[InterfaceTarget]:
    flags = ("ADD_LINTER_TESTS", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK")
    for call in calls:
        if call.name == "rosidl_generate_interfaces" and call.words:
            words = as_value(call.words[1:])  # a macro: what is quoted is split at `;` once more
            used_flags, values, files = flags_and_values(words, flags, ("LIBRARY_NAME",), ("DEPENDENCIES",))
            needs = tuple(values.get("DEPENDENCIES", []))
            yield InterfaceTarget(call.words[0], tuple(files), needs, "SKIP_INSTALL" in used_flags, call)
