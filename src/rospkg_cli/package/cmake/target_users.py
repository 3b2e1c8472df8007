"""Which commands use the file that is built of a target: `$<TARGET_FILE:…>`, a custom command, a test."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand

SETTERS = ("target_", "set_target_properties", "ament_target_dependencies", "rosidl_target_interfaces",
           "ament_export_", "install", "add_dependencies", "set_property", "ament_auto_add_")  # fmt: skip
"""Commands that name a target without using its file."""
NAMING = ("project", "find_package", "set", "list", "foreach", "message")
"""Commands that name packages, one of which a target may share its name with, or that use nothing themselves."""
MAX_PARTS = 5
"""Behind the first `:` of `$<TARGET_FILE:ns::talker>` there are three parts, separated by `:`."""


def users_by_name(calls: Iterable[EvaluatedCommand]) -> dict[str, list[EvaluatedCommand]]:
    """Return the calls that use what is built of a target, by the name of the target."""
    found: dict[str, list[EvaluatedCommand]] = {}
    for call in calls:
        for name in dict.fromkeys(used_by(call)):
            found.setdefault(name, []).append(call)
    return found


def used_by(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the names of targets of which a call uses what is built, if they are targets."""
    setter = call.name.startswith(SETTERS)
    if (setter and call.name != "install") or call.name in NAMING:
        return
    for text in call.texts:
        if not setter:
            yield text
        for piece in text.split(">")[:-1]:
            parts = piece.rpartition("<")[2].split(":")
            yield from (":".join(parts[-count:]) for count in range(1, min(len(parts), MAX_PARTS + 1)))
