"""Headers of messages that a build makes in addition to those of rosidl, for other middlewares, say (IDL012)."""

from __future__ import annotations

import posixpath

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import unfamiliar_commands
from ...package.cmake.made_paths import files_written_by


def may_be_generated(header: str, cmake: CMake) -> bool:
    """Return whether a command writes a header, or a macro of another package is given the message of that name."""
    if any(is_given(header, call) for call in unfamiliar_commands(cmake)):
        return True
    return any(word.text.endswith(f"/{header}") for call in cmake.calls for word in files_written_by(call))


def is_given(header: str, call: EvaluatedCommand) -> bool:
    """Return whether a macro is given the message of `std_msgs/msg/String.hpp`, in its own letters.

    As `std_msgs/String` or `std_msgs/msg/String`, with or without the suffix of the file, or as two words.
    """
    package, kind, file = header.split("/")
    name = posixpath.splitext(file)[0]
    given = {part.removesuffix(f".{kind}").removesuffix(".idl") for text in call.texts for part in text.split(";")}
    return not given.isdisjoint({f"{package}/{name}", f"{package}/{kind}/{name}"}) or {package, name} <= given
