"""MoveIt's builder of parameters: its package, and the files of it that its methods read."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call
from .file_references import ReferenceKind
from .python_to_text import text_of
from .text import LaunchText, Literal, Substitution

BUILDER, ENDING = "MoveItConfigsBuilder", "_moveit_config"
READING: dict[str, ReferenceKind] = {
    "robot_description": "file",  # without it, it waits for the topic
    "robot_description_semantic": "open",
    "robot_description_kinematics": "open",
    "joint_limits": "open",
    "moveit_cpp": "open",
    "trajectory_execution": "open",
    "pilz_cartesian_limits": "open",
}
"""Methods that take a path in the package; `sensors_3d` looks first whether it is there."""


def builder_package(call: Call) -> LaunchText | None:
    """Return the package of a builder, as it is written or made of the robot's name; None where it is not known.

    (moveit_configs_utils/moveit_configs_builder.py: `package_name or robot_name + "_moveit_config"`)
    """
    if call.callee.rpartition(".")[2] != BUILDER or call.receiver is not None or call.rest is not None:
        return None
    package = call.get("package_name")
    given = package or call.get("robot_name", 0)
    text = text_of(given) if given is not None else None
    if text is None or not text.literal:
        return None
    return text if package is not None else LaunchText(text.span, (Literal(f"{text.literal}{ENDING}", text.span),))


def files_read(call: Call) -> Iterator[tuple[ReferenceKind, LaunchText]]:
    """Yield the file that a method of a builder reads, which stops the launch where it is missing."""
    path = call.get("file_path", 0) if call.callee in READING else None
    package = package_of(call.receiver) if path is not None and isinstance(call.receiver, Call) else None
    if path is not None and package is not None:
        text = text_of(path)
        if text.literal and not text.literal.startswith("/"):
            share = Substitution("find-pkg-share", (package,), package.span)
            text = LaunchText(text.span, (share, Literal("/", text.span), *text.parts))
        yield READING[call.callee], text


def package_of(call: Call) -> LaunchText | None:
    """Return the package of the builder that a chain of calls begins with."""
    while isinstance(call.receiver, Call):
        call = call.receiver
    return builder_package(call)
