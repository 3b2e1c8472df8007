"""Calls of CMake and ament with arguments that are refused, or taken for something else than is intended (CMK123)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN
from ...package.cmake.cmake_project import CMake
from .install_arguments import misplaced_words, without_destination
from .refused_argument import RefusedArgument
from .target_arguments import late_keywords, linked_keywords, unscoped, without_sign

COUNTS = {
    "pluginlib_export_plugin_description_file": (2, "the package of the base class and the description's path"),
    "generate_parameter_library": (2, "the library's name and the YAML file"),
    "rosidl_get_typesupport_target": (3, "a variable, the interface target and a typesupport"),
}
"""How many arguments a command needs at least, and which."""


def refused_calls(cmake: CMake) -> Iterator[RefusedArgument]:
    """Yield each place once; nothing for commands that the package defines itself."""
    seen: set[tuple[str, int]] = set()
    for call in cmake.calls:
        place = (call.path, call.command.span.start)
        if place in seen or call.name in cmake.functions:
            continue
        seen.add(place)
        yield from unscoped(call)
        yield from without_destination(call)
        yield from misplaced_words(cmake, call)
        yield from late_keywords(cmake, call)
        yield from linked_keywords(cmake, call)
        yield from too_few(call)
        yield from without_sign(call)


def too_few(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield a call that is given fewer arguments than its command needs."""
    if call.name in COUNTS and not any(UNKNOWN in text for text in call.texts):
        count, which = COUNTS[call.name]
        if len(call.words) < count:
            yield RefusedArgument(call, None, f"`{call.name}` wants {which}: CMake stops; name them all")
